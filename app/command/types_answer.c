#include "command/types_answer.h"

#include <stdio.h>

#include "base/stopwatch.h"
#include "command/progress.h"
#include "platform/terminal.h"
#include "result/json.h"
#include "result/text.h"
#include "result/types.h"

/* Classifying ---------------------------------------------------------------------------------------------------------
 */

typedef struct Progress {
    double begin; /* s, by the clock */
    bool shown;
} Progress;

/* After a second, so that what is quick stays quiet. */
static void show_progress(void *context, size_t done, size_t all) {
    Progress *progress = context;
    if (stopwatch_now() - progress->begin < 1)
        return;
    terminal_progress("types: %zu of at most %zu runs ", done, all);
    progress->shown = true;
}

bool types_answer_classify(Types *types, const Experiment *experiment, const Experiment *thorough,
                           const char *const *names, size_t name_count, const Options *options, Fault *fault) {
    Progress progress = {.begin = stopwatch_now()};
    bool show = progress_is_shown(options);
    TypesTask task = {.experiment = experiment,
                      .thorough = thorough,
                      .names = names,
                      .name_count = name_count,
                      .jobs = options->jobs,
                      .stop = &progress_stop,
                      .progress = show ? show_progress : NULL,
                      .context = &progress};
    bool good = types_classify(types, &task, fault);
    if (progress.shown)
        terminal_clear_progress();
    return good;
}

/* Text ------------------------------------------------------------------------------------------------------------- */

void types_answer_print(const Types *types, const Experiment *experiment, int cycles) {
    ResultTable basis = result_types_basis(types, experiment, cycles);
    printf("%s", result_find(&basis, 0, "advice")->text);
    result_clear(&basis);
}

void types_answer_print_parameters(const Types *types, const Experiment *experiment) {
    Text text = {0};
    result_text_take(&text, "", result_types_parameters(types, experiment));
    printf("%s", text.text ? text.text : "");
    memory_free(text.text);
}

/* JSON ------------------------------------------------------------------------------------------------------------- */

static json_t *points_json(const Types *types, const Experiment *experiment) {
    json_t *points = result_json_take_list(result_types_points(types, experiment));
    for (size_t i = 0; i < types->point_count; i++)
        json_object_set_new(json_array_get(points, i), "answers",
                            result_json_take_list(result_types_answers(&types->points[i], experiment)));
    return points;
}

json_t *types_answer_json(const Types *types, const Experiment *experiment, int cycles) {
    json_t *answer = json_object();
    result_json_take_record(answer, result_types_kind(types));
    json_object_set_new(answer, "points", points_json(types, experiment));
    json_object_set_new(answer, "parameters", result_json_take_list(result_types_parameters(types, experiment)));
    result_json_take_record(answer, result_types_basis(types, experiment, cycles));
    return answer;
}
