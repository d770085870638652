#include "command/types_answer.h"

#include <math.h>
#include <stdio.h>

#include "base/clock.h"
#include "command/progress.h"
#include "visual/study/advice.h"

/* Telling --------------------------------------------------------------------------------------------------------- */

typedef struct Progress {
    double begin; /* s, by the clock */
    bool shown;
} Progress;

/* After a second, so that what is quick stays quiet. */
static void show_progress(void *context, size_t done, size_t all) {
    Progress *progress = context;
    if (clock_now() - progress->begin < 1)
        return;
    fprintf(stderr, "\rtypes: %zu of at most %zu runs", done, all);
    progress->shown = true;
}

bool types_answer_tell(Types *types, const Experiment *experiment, const Experiment *thorough, const char *const *names,
                       size_t name_count, const Options *options, Fault *fault) {
    Progress progress = {.begin = clock_now()};
    bool show = progress_is_shown(options);
    TypesTask task = {.experiment = experiment,
                      .thorough = thorough,
                      .names = names,
                      .name_count = name_count,
                      .jobs = options->jobs,
                      .stop = &progress_interrupted,
                      .progress = show ? show_progress : NULL,
                      .context = &progress};
    bool good = types_classify(types, &task, fault);
    if (progress.shown)
        fprintf(stderr, "\n");
    return good;
}

/* Words ----------------------------------------------------------------------------------------------------------- */

void types_answer_print(const Types *types, const Experiment *experiment, const char *each) {
    Text text = {0};
    advice_write(&text, types, experiment, each);
    printf("%s", text.text);
    memory_free(text.text);
}

/* JSON ------------------------------------------------------------------------------------------------------------ */

static json_t *known(double value) {
    return isfinite(value) ? json_number(value) : json_null();
}

static json_t *side_json(const Neighbour *side) {
    return json_pack("{s:o, s:o, s:o}", "at", known(side->found ? side->value : NAN), "away",
                     known(side->found ? side->share : NAN), "looked", json_number(side->reached));
}

static json_t *parameter_json(const TypesParameter *parameter, const Experiment *experiment) {
    return json_pack("{s:s, s:s, s:o, s:o, s:b, s:o, s:o}", "name", parameter->name, "unit",
                     experiment->parameter(experiment->given, parameter->name)->unit, "value",
                     json_number(parameter->nominal), "sensitivity", known(parameter->sensitivity), "jumps",
                     isinf(parameter->sensitivity) != 0, "below", side_json(&parameter->below), "above",
                     side_json(&parameter->above));
}

static json_t *point_json(const Types *types, const TypesPoint *point, const Experiment *experiment) {
    bool centre = point->parameter == types->parameter_count;
    json_t *answers = json_array();
    for (size_t a = 0; a < point->answer_count; a++)
        json_array_append_new(
            answers, json_pack("{s:o, s:o, s:I}", experiment->observables[experiment->outcome].name,
                               known(point->answers[a].outcome), experiment->observables[experiment->measure].name,
                               known(point->answers[a].measure), "starts", (json_int_t)point->answers[a].starts));
    return json_pack("{s:o, s:o, s:b, s:I, s:I, s:o}", "parameter",
                     centre ? json_null() : json_string(types->parameters[point->parameter].name), "value",
                     known(point->value), "possible", point->possible, "irregular", (json_int_t)point->irregular,
                     "untold", (json_int_t)point->undecided, "answers", answers);
}

static const char *reason_name(TypesReason reason) {
    static const char *const names[] = {
        [TYPES_ALL_WELL] = "one answer",     [TYPES_STEEP_ANSWER] = "steep", [TYPES_SEVERAL] = "several answers",
        [TYPES_NOT_REGULAR] = "not regular", [TYPES_FLIPS] = "flips",        [TYPES_UNDECIDED] = "cannot be told"};
    return names[reason];
}

json_t *types_answer_json(const Types *types, const Experiment *experiment, const char *each) {
    json_t *parameters = json_array(), *points = json_array();
    for (size_t p = 0; p < types->parameter_count; p++)
        json_array_append_new(parameters, parameter_json(&types->parameters[p], experiment));
    for (size_t i = 0; i < types->point_count; i++)
        json_array_append_new(points, point_json(types, &types->points[i], experiment));
    Text text = {0};
    advice_write(&text, types, experiment, each);
    json_t *answer =
        json_pack("{s:s, s:s, s:I, s:I, s:i, s:o, s:o, s:s, s:I, s:I, s:I, s:b, s:s}", "type",
                  types_kind_name(types->kind), "reason", reason_name(types->reason), "worst", (json_int_t)types->worst,
                  "answers", (json_int_t)types->answers, "starts", TYPES_STARTS, "points", points, "parameters",
                  parameters, "sought", types->sought == NEIGHBOURS_TROUBLE ? "trouble" : "regular", "runs",
                  (json_int_t)types->runs, "thorough", (json_int_t)types->thorough, "neighbour_runs",
                  (json_int_t)types->neighbour_runs, "stopped", types->stopped, "advice", text.text);
    memory_free(text.text);
    return answer;
}
