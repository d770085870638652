#include "command/suggestions.h"

#include <stdio.h>

#include "base/stopwatch.h"
#include "command/output.h"
#include "command/progress.h"
#include "platform/terminal.h"
#include "laboratory/shipped.h"
#include "result/json.h"
#include "result/suggest.h"
#include "result/text.h"

/* Progress, once the work has taken more than a second. */
typedef struct Progress {
    double begin; /* s, by the clock */
    bool shown;
} Progress;

static void show_progress(void *context, size_t tries) {
    Progress *progress = context;
    if (stopwatch_now() - progress->begin < 1)
        return;
    terminal_progress("%zu changed houses tried ", tries);
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
                        .stop = &progress_stop,
                        .progress = progress_is_shown(options) ? show_progress : NULL,
                        .context = &progress};
    bool good = suggest_find(list, &task, fault);
    if (progress.shown)
        terminal_clear_progress();
    return good;
}

void suggestions_add(json_t *answer, const SuggestList *list) {
    json_t *suggestions = result_json_take_list(result_suggest_changes(list)), *notes = json_array();
    for (size_t i = 0; i < list->note_count; i++)
        json_array_append_new(notes, json_string(list->notes[i]));
    json_object_set_new(answer, "suggestions", suggestions);
    json_object_set_new(answer, "suggestion_notes", notes);
    json_object_set_new(answer, "suggestions_complete", json_boolean(!list->stopped && !list->exhausted));
}

void suggestions_print(const SuggestList *list) {
    Arena arena = {0};
    Text text = {0};
    text_format(&text, "\n%s\n", result_suggest_sentence(list, &arena));
    result_text_take(&text, "", result_suggest_changes(list));
    if (!list->out_already)
        text_format(&text, "\n%s\n", result_suggest_tried(list, &arena));
    for (size_t i = 0; i < list->note_count; i++)
        text_format(&text, "note: %s\n", list->notes[i]);
    output_text(&text);
    memory_free(text.text);
    arena_clear(&arena);
}
