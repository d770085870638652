#include "laboratory/edit/propose.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/stop.h"
#include "base/text.h"
#include "plan/draft_parameter.h"
#include "inquiry/suggest.h"
#include "laboratory/edit/gesture.h"
#include "result/suggest.h"

/* A search that was requested. */
struct EditSearch {
    pthread_t thread;
    Stop stop;
    uint64_t revision; /* the draft's revision that the search is for */
    char *text, *path, *profiles;
    HouseOptions options;
    int jobs;
    pthread_mutex_t mutex; /* guards all members that follow */
    size_t tries;
    bool over;
    /* The result, once the search is over. */
    SuggestList list;
    Proposal rows[SUGGEST_MOST];
    const char *none; /* the text for an empty list; NULL: the texts are not written yet */
    Arena arena;      /* holds the texts */
    EditSearch *next; /* the next search in the list of cancelled searches that have not ended yet */
};

static void count_tries(void *context, size_t tries) {
    EditSearch *search = context;
    pthread_mutex_lock(&search->mutex);
    search->tries = tries;
    pthread_mutex_unlock(&search->mutex);
}

static void *search_changes(void *context) {
    EditSearch *search = context;
    Fault none = {0}; /* an invalid house has no proposals; its run reports the error */
    SuggestTask task = {.path = search->path,
                        .text = search->text,
                        .options = &search->options,
                        .jobs = search->jobs,
                        .stop = &search->stop,
                        .progress = count_tries,
                        .context = search};
    SuggestList list = {0};
    suggest_find(&list, &task, &none);
    fault_clear(&none);
    pthread_mutex_lock(&search->mutex);
    search->list = list;
    search->over = true;
    pthread_mutex_unlock(&search->mutex);
    return NULL;
}

static bool is_over(EditSearch *search) {
    pthread_mutex_lock(&search->mutex);
    bool over = search->over;
    pthread_mutex_unlock(&search->mutex);
    return over;
}

static void destroy(EditSearch *search) {
    pthread_join(search->thread, NULL);
    pthread_mutex_destroy(&search->mutex);
    suggest_clear(&search->list);
    arena_clear(&search->arena);
    memory_free(search->text);
    memory_free(search->path);
    memory_free(search->profiles);
    memory_free(search);
}

/* Releases the cancelled searches that have ended. */
static void reap(Editor *edit, bool wait) {
    EditSearch **at = &edit->cancelled;
    while (*at) {
        EditSearch *search = *at;
        if (!wait && !is_over(search)) {
            at = &search->next;
            continue;
        }
        *at = search->next;
        destroy(search);
    }
}

static void cancel_search(Editor *edit) {
    EditSearch *search = edit->search;
    if (!search)
        return;
    stop_request(&search->stop);
    search->next = edit->cancelled;
    edit->cancelled = search;
    edit->search = NULL;
}

bool edit_propose_drop(Editor *edit) {
    bool any = edit->search;
    cancel_search(edit);
    reap(edit, false);
    return any;
}

void edit_propose_end(Editor *edit) {
    cancel_search(edit);
    reap(edit, true);
}

void edit_propose_ask(Editor *edit) {
    cancel_search(edit);
    reap(edit, false);
    EditSearch *search = memory_zeroed(1, sizeof *search);
    search->revision = draft_revision(edit->draft);
    search->text = text_copy(draft_text(edit->draft));
    search->path = text_copy(edit->options.path);
    search->profiles = text_copy(edit->options.profiles);
    search->options =
        (HouseOptions){.profiles = search->profiles, .seed = edit->options.seed, .driving = edit->options.driving};
    search->jobs = edit->options.jobs;
    pthread_mutex_init(&search->mutex, NULL);
    if (pthread_create(&search->thread, NULL, search_changes, search) == 0) {
        edit->search = search;
        return;
    }
    pthread_mutex_destroy(&search->mutex);
    memory_free(search->text);
    memory_free(search->path);
    memory_free(search->profiles);
    memory_free(search);
}

/* Writes the texts of the result once. */
static void write_texts(EditSearch *search) {
    const SuggestList *list = &search->list;
    bool explained = list->note_count && !list->out_already;
    for (size_t i = 0; i < list->count; i++)
        search->rows[i] = (Proposal){list->list[i].text, result_suggest_outcome(&list->list[i], &search->arena)};
    search->none = explained ? list->notes[0] : result_suggest_sentence(list, &search->arena);
}

const Proposal *edit_propose_list(Editor *edit, size_t *count, const char **doing) {
    EditSearch *search = edit->search;
    *count = 0;
    *doing = NULL;
    if (search && search->revision != draft_revision(edit->draft))
        cancel_search(edit); /* the search is for another house */
    reap(edit, false);
    search = edit->search;
    if (!search)
        return NULL;
    if (!is_over(search)) {
        pthread_mutex_lock(&search->mutex);
        snprintf(edit->proposing, sizeof edit->proposing, "%zu tried", search->tries);
        pthread_mutex_unlock(&search->mutex);
        *doing = edit->proposing;
        return NULL;
    }
    *count = search->list.count;
    if (!search->none)
        write_texts(search);
    if (!*count)
        *doing = search->none;
    return search->rows;
}

/* Sets one NAME=VALUE of a proposal. */
static bool set(Editor *edit, const char *setting, Fault *fault) {
    const char *equals = strchr(setting, '=');
    char name[2 * EDIT_NAME];
    snprintf(name, sizeof name, "%.*s", (int)(equals - setting), setting);
    json_t *value = json_loads(equals + 1, JSON_DECODE_ANY, NULL);
    return draft_parameter_set(edit->draft, name, value ? value : json_string(equals + 1), fault);
}

bool edit_propose_accept(Editor *edit, size_t proposal, Fault *fault) {
    size_t count;
    const char *doing;
    edit_propose_list(edit, &count, &doing);
    if (proposal >= count) {
        fault_add(fault, "this proposal is out of date: ask for new ones");
        return false;
    }
    const Suggestion *chosen = &edit->search->list.list[proposal];
    bool good = true;
    edit_gesture_begin_step(edit, chosen->text);
    for (size_t i = 0; i < chosen->setting_count && good; i++)
        good = set(edit, chosen->settings[i], fault);
    if (good)
        return edit_gesture_end_step(edit, fault);
    draft_cancel(edit->draft);
    return false;
}
