#include "command/suggestions.h"

#include <stdio.h>

#include "base/stopwatch.h"
#include "command/progress.h"
#include "laboratory/shipped.h"

/* Progress, once the work has taken more than a second. */
typedef struct Progress {
    double begin; /* s, by the clock */
    bool shown;
} Progress;

static void show_progress(void *context, size_t tries) {
    Progress *progress = context;
    if (stopwatch_now() - progress->begin < 1)
        return;
    fprintf(stderr, "\r%zu changed houses tried ", tries);
    progress->shown = true;
}

bool suggestions_find(SuggestList *list, const Options *options, Fault *fault) {
    Progress progress = {.begin = stopwatch_now()};
    HouseOptions house_options = {.profiles = shipped_places()->profiles,
                                  .settings = options->settings,
                                  .setting_count = options->setting_count,
                                  .seed = options->seed,
                                  .driving = options->driving};
    SuggestTask task = {.path = options->files[0],
                        .options = &house_options,
                        .jobs = options->jobs,
                        .stop = &progress_interrupted,
                        .progress = progress_is_shown(options) ? show_progress : NULL,
                        .context = &progress};
    bool good = suggest_find(list, &task, fault);
    if (progress.shown)
        fprintf(stderr, "\r%40s\r", "");
    return good;
}

static json_t *one_suggestion(const Suggestion *suggestion) {
    json_t *settings = json_array();
    for (size_t s = 0; s < suggestion->setting_count; s++)
        json_array_append_new(settings, json_string(suggestion->settings[s]));
    return json_pack("{s:s, s:o, s:f, s:f}", "words", suggestion->words, "settings", settings, "size", suggestion->size,
                     "time", suggestion->time);
}

void suggestions_add(json_t *answer, const SuggestList *list) {
    json_t *suggestions = json_array(), *notes = json_array();
    for (size_t i = 0; i < list->count; i++)
        json_array_append_new(suggestions, one_suggestion(&list->list[i]));
    for (size_t i = 0; i < list->note_count; i++)
        json_array_append_new(notes, json_string(list->notes[i]));
    json_object_set_new(answer, "suggestions", suggestions);
    json_object_set_new(answer, "suggestion_notes", notes);
    json_object_set_new(answer, "suggestions_complete", json_boolean(!list->stopped && !list->exhausted));
}

static void print_tried(const SuggestList *list) {
    printf("\n%zu houses were tried%s\n", list->tries,
           list->stopped     ? ", then it was interrupted: there may be others"
           : list->exhausted ? ", as many as are allowed: there may be others"
                             : "");
    for (size_t i = 0; i < list->note_count; i++)
        printf("  %s\n", list->notes[i]);
}

void suggestions_print(const SuggestList *list) {
    if (list->out_already) {
        printf("\neverybody gets out as it is, in %.1f s: nothing needs to be changed\n", list->time);
        return;
    }
    printf(list->count     ? "\nsmallest changes that let everybody out:\n"
           : list->stopped ? "\ninterrupted before a change was found that lets everybody out\n"
                           : "\nno change was found that lets everybody out\n");
    for (size_t i = 0; i < list->count; i++) {
        const Suggestion *suggestion = &list->list[i];
        printf("%2zu  %s: everybody out in %.1f s\n     (%.2f m of change:", i + 1, suggestion->words, suggestion->time,
               suggestion->size);
        for (size_t s = 0; s < suggestion->setting_count; s++)
            printf(" --set %s", suggestion->settings[s]);
        printf(")\n");
    }
    print_tried(list);
}
