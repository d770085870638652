#include "laboratory/edit/propose.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/stop.h"
#include "base/text.h"
#include "plan/draft_parameter.h"
#include "inquiry/suggest.h"
#include "laboratory/edit/gesture.h"
#include "result/names.h"
#include "result/suggest.h"

/* A search that was requested. */
struct EditSearch {
    pthread_t thread;
    Stop stop;
    uint64_t revision; /* the draft's revision that the search is for */
    uint64_t number;   /* of the search */
    size_t chosen;     /* the proposal that is shown */
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
    search->number = ++edit->search_count;
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

/* Returns the item that a setting changes, "door.d3.width=0.82": its index in the plan. */
static Item changed_item(Editor *edit, const char *setting) {
    const char *point = strchr(setting, '.');
    size_t index = 0;
    bool door = strncmp(setting, "door.", 5) == 0;
    for (const char *end = point ? strchr(point + 1, '.') : NULL; end; end = strchr(end + 1, '.')) {
        char id[EDIT_NAME]; /* which may have points itself */
        snprintf(id, sizeof id, "%.*s", (int)(end - point - 1), point + 1);
        DraftList list = draft_find(edit->draft, id, &index);
        if (list == (door ? DRAFT_DOORS : DRAFT_FURNITURE))
            return (Item){door ? HOUSE_DOOR : HOUSE_FURNITURE, index};
    }
    return (Item){0, 0};
}

static const char *width_label(const char *setting, Arena *arena) {
    static const char width[] = ".width=";
    const char *at = strstr(setting, width);
    return at && strncmp(setting, "door.", 5) == 0 ? text_in_arena(arena, "%.2f m", strtod(at + sizeof width - 1, NULL))
                                                   : NULL;
}

/* Returns the texts of a suggestion, with the names of things as the window has them. */
static Proposal proposal_of(Editor *edit, EditSearch *search, const Suggestion *suggestion) {
    const House *house = edit->scene.scenery.house;
    Arena *arena = &search->arena;
    return (Proposal){.text = house ? names_text(house, suggestion->text, arena) : suggestion->text,
                      .answer = result_suggest_outcome(suggestion, arena),
                      .size = suggestion->size < 1 ? text_in_arena(arena, "%.0f cm", 100 * suggestion->size)
                                                   : text_in_arena(arena, "%.2f m", suggestion->size),
                      .settings = suggestion->settings,
                      .setting_count = suggestion->setting_count,
                      .item = changed_item(edit, suggestion->settings[0]),
                      .label = width_label(suggestion->settings[0], arena)};
}

/* Writes the texts of the result once. */
static void write_texts(Editor *edit, EditSearch *search) {
    const SuggestList *list = &search->list;
    bool explained = list->note_count && !list->out_already;
    for (size_t i = 0; i < list->count; i++)
        search->rows[i] = proposal_of(edit, search, &list->list[i]);
    const House *house = edit->scene.scenery.house;
    search->none = explained ? list->notes[0] : result_suggest_sentence(list, &search->arena);
    if (house)
        search->none = names_text(house, search->none, &search->arena);
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
        snprintf(edit->proposing, sizeof edit->proposing, "Searching: %zu tried", search->tries);
        pthread_mutex_unlock(&search->mutex);
        *doing = edit->proposing;
        return NULL;
    }
    *count = search->list.count;
    if (!search->none)
        write_texts(edit, search);
    if (!*count)
        *doing = search->none;
    return search->rows;
}

void edit_propose_choose(Editor *edit, size_t proposal) {
    if (edit->search && proposal < edit->search->list.count)
        edit->search->chosen = proposal;
}

uint64_t edit_propose_chosen(Editor *edit, size_t *proposal) {
    size_t count;
    const char *doing;
    *proposal = 0;
    edit_propose_list(edit, &count, &doing);
    if (!count)
        return 0;
    *proposal = edit->search->chosen;
    return edit->search->number * (SUGGEST_MOST + 1) + *proposal;
}

size_t edit_propose_tries(const Editor *edit) {
    EditSearch *search = edit->search;
    if (!search)
        return 0;
    pthread_mutex_lock(&search->mutex);
    size_t tries = search->over ? search->list.tries : search->tries;
    pthread_mutex_unlock(&search->mutex);
    return tries;
}

bool edit_propose_seeks(const Editor *edit) {
    return edit->search && !is_over(edit->search);
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
    edit_gesture_begin_step(edit, edit->search->rows[proposal].text);
    for (size_t i = 0; i < chosen->setting_count && good; i++)
        good = set(edit, chosen->settings[i], fault);
    if (good)
        return edit_gesture_end_step(edit, fault);
    draft_cancel(edit->draft);
    return false;
}
