#include "command/study_answer.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "base/json.h"
#include "study/montecarlo.h"
#include "study/summary.h"

static json_t *known(double value) {
    return isfinite(value) ? json_number(value) : json_null();
}

static json_t *whole(size_t value) {
    return json_integer((json_int_t)value);
}

static void set(json_t *object, const char *key, json_t *value) {
    json_object_set_new(object, key, value);
}

static const char *unit_of(const Study *study, const char *name) {
    return study->experiment->parameter(study->experiment->given, name)->unit;
}

static json_t *make_axes(const Study *study) {
    json_t *axes = json_array();
    for (size_t a = 0; a < study->axis_count; a++) {
        const StudyAxis *axis = &study->axes[a];
        json_array_append_new(axes, json_pack("{s:s, s:s, s:o, s:o, s:o}", "name", axis->name, "unit",
                                              unit_of(study, axis->name), "from", known(axis->from), "to",
                                              known(axis->to), "steps", whole(axis->steps)));
    }
    return axes;
}

static json_t *make_spreads(const Study *study) {
    json_t *spreads = json_array();
    for (size_t s = 0; s < study->spread_count; s++)
        json_array_append_new(
            spreads, json_pack("{s:s, s:o}", "name", study->spreads[s].name, "share", known(study->spreads[s].share)));
    return spreads;
}

static json_t *make_passes(const Study *study) {
    json_t *passes = json_array();
    for (size_t p = 0; p < study->pass_count; p++)
        json_array_append_new(passes, json_string(study_pass_name(study->passes[p])));
    return passes;
}

static void add_ranges(json_t *list, const Study *study, size_t pass, size_t a) {
    const StudyAxis *axis = &study->axes[a];
    size_t count;
    SummaryRange *ranges = summary_ranges(study, pass, a, &count);
    for (size_t r = 0; r < count; r++)
        json_array_append_new(list,
                              json_pack("{s:s, s:s, s:o, s:o, s:o, s:s}", "pass", study_pass_name(study->passes[pass]),
                                        "name", axis->name, "from", known(study_value(axis, ranges[r].first)), "to",
                                        known(study_value(axis, ranges[r].last)), "steps",
                                        whole(ranges[r].last - ranges[r].first + 1), "answer",
                                        summary_state_name(ranges[r].state)));
    memory_free(ranges);
}

static json_t *make_ranges(const Study *study) {
    json_t *list = json_array();
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t a = 0; a < study->axis_count; a++)
            add_ranges(list, study, pass, a);
    return list;
}

/* Where along the only axis the passes end in different answers. */
static json_t *make_differences(const Study *study) {
    json_t *at = json_array();
    for (size_t i = 0; i < study_steps(study, 0); i++)
        if (summary_passes_differ(study, 0, i))
            json_array_append_new(at, known(study_value(&study->axes[0], i)));
    return at;
}

/* The run with the least, or the greatest measure; null: there is none. */
static json_t *make_extreme(const Study *study, bool greatest) {
    size_t index = summary_extreme(study, greatest);
    if (index == SIZE_MAX)
        return json_null();
    const Trial *trial = &study->trials[index];
    json_t *at = json_object();
    for (size_t n = 0; n < study->name_count; n++)
        set(at, study->names[n], known(trial->at[n]));
    return json_pack("{s:o, s:o, s:s, s:I}", "value", known(trial->observed[study->experiment->measure]), "at", at,
                     "pass", study_pass_name(study->passes[study_pass_of(study, index)]), "seed",
                     (json_int_t)trial->seed);
}

/* Of the runs of a study without an axis, each observable as a distribution. */
static json_t *make_distributions(const Study *study) {
    MontecarloPoint point = montecarlo_point(study, 0, 0, 0);
    json_t *distributions = json_object();
    for (size_t o = 0; o < point.observables; o++) {
        const Observable *observable = &study->experiment->observables[o];
        const Distribution *d = &point.of[o];
        set(distributions, observable->name,
            json_pack("{s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "unit", observable->unit, "count",
                      whole(d->count), "mean", known(d->mean), "deviation", known(d->deviation), "standard_error",
                      known(d->error), "q05", known(d->low), "q50", known(d->median), "q95", known(d->high), "least",
                      known(d->least), "greatest", known(d->greatest)));
    }
    json_t *share = json_pack("{s:o, s:o, s:o}", "value", known(point.share), "q025", known(point.share_low), "q975",
                              known(point.share_high));
    montecarlo_clear(&point);
    return json_pack("{s:o, s:o}", "share_regular", share, "observables", distributions);
}

static json_t *first_fault(const Study *study) {
    for (size_t t = 0; t < study->trial_count; t++)
        if (study->trials[t].fault)
            return json_string(study->trials[t].fault);
    return json_null();
}

json_t *study_answer_make(const Study *study, const char *file) {
    const Experiment *experiment = study->experiment;
    const Observable *regular = &experiment->observables[experiment->regular],
                     *measure = &experiment->observables[experiment->measure];
    SummaryCount count = summary_count(study);
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, summary_digest(study));
    json_t *answer =
        json_pack("{s:s, s:s, s:s, s:o, s:o, s:o, s:o, s:I}", "kind", "study", "experiment", experiment->kind, "file",
                  file, "axes", make_axes(study), "spreads", make_spreads(study), "passes", make_passes(study), "runs",
                  whole(study->runs), "seed", (json_int_t)study->seed);
    set(answer, "trials", whole(count.trials));
    set(answer, "done", whole(count.done));
    set(answer, "faults", whole(count.faults));
    set(answer, "first_fault", first_fault(study));
    set(answer, "regular", whole(count.regular));
    set(answer, "not_regular", whole(count.irregular));
    set(answer, "cannot_be_told", whole(count.undecided));
    set(answer, "regular_means", json_string(regular->meaning));
    set(answer, "measure",
        json_pack("{s:s, s:s, s:s}", "name", measure->name, "unit", measure->unit, "meaning", measure->meaning));
    set(answer, "ranges", make_ranges(study));
    if (study->axis_count == 1 && study->pass_count > 1)
        set(answer, "passes_differ_at", make_differences(study));
    set(answer, "best", make_extreme(study, false));
    set(answer, "worst", make_extreme(study, true));
    if (!study->axis_count && study->runs > 1)
        set(answer, "distribution", make_distributions(study));
    set(answer, "digest", json_string(digest));
    return answer;
}
