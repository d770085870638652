#include "command/study_answer.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "base/json.h"
#include "result/json.h"
#include "result/study.h"
#include "result/study_grades.h"
#include "study/basins.h"

static void set(json_t *object, const char *key, json_t *value) {
    json_object_set_new(object, key, value);
}

static json_t *make_passes(const Study *study) {
    json_t *passes = json_array();
    for (size_t p = 0; p < study->pass_count; p++)
        json_array_append_new(passes, json_string(study_pass_name(study->passes[p])));
    return passes;
}

/* Where along the only axis the passes end in different answers. */
static json_t *make_differences(const Study *study) {
    json_t *at = json_array();
    for (size_t i = 0; i < study_steps(study, 0); i++)
        if (summary_passes_differ(study, 0, i))
            json_array_append_new(at, json_number(study_value(&study->axes[0], i)));
    return at;
}

/* The run with the least, or the greatest measure; null: there is none. */
static json_t *make_extreme(const Study *study, bool greatest) {
    size_t index = summary_extreme(study, greatest);
    if (index == SIZE_MAX)
        return json_null();
    json_t *extreme = json_pack("{s:n, s:{}}", "value", "at");
    result_json_take_record(extreme, result_study_extreme(study, greatest));
    set(extreme, "seed", json_integer((json_int_t)study_nth(study, index)->seed));
    return extreme;
}

/* Returns the distribution of each observable over the runs of a study without an axis. */
static json_t *make_distributions(const Study *study) {
    ResultTable table = result_study_distributions(study);
    json_t *share = json_object(), *distributions = json_object();
    result_json_take_record(share, result_study_share(study));
    for (size_t o = 0; o < table.record_count; o++)
        set(distributions, result_at(&table, o, 0)->text, result_json_record(&table, o));
    result_clear(&table);
    return json_pack("{s:o, s:o}", "share_regular", share, "observables", distributions);
}

/* Returns the shares of the basins at each value. */
static json_t *make_basins(const Study *study) {
    json_t *values = json_array();
    for (size_t i = 0; i < study_steps(study, 0); i++) {
        Basins basins = basins_at(study, i);
        json_t *list = json_array();
        for (size_t k = 0; k < basins.count; k++) {
            const Basin *basin = &basins.of[k];
            char name[60];
            basins_name(study, basin, name, sizeof name);
            json_array_append_new(list, json_pack("{s:s, s:o, s:I, s:o, s:o, s:o, s:I}", "answer", name,
                                                  study->experiment->observables[study->experiment->measure].name,
                                                  json_number(basin->measure), "starts", (json_int_t)basin->share.good,
                                                  "share", json_number(basin->share.value), "low",
                                                  json_number(basin->share.low), "high", json_number(basin->share.high),
                                                  "others", (json_int_t)basin->others));
        }
        json_array_append_new(values,
                              json_pack("{s:o, s:I, s:o, s:o}", "value", json_number(study_value(&study->axes[0], i)),
                                        "starts", (json_int_t)basins.starts, "unseen_below",
                                        json_number(basins.unseen_below), "basins", list));
    }
    return values;
}

json_t *study_answer_make(const Study *study, const char *file) {
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, summary_digest(study));
    json_t *answer =
        json_pack("{s:s, s:s, s:s, s:o, s:o, s:o, s:I, s:I}", "kind", "study", "experiment", study->experiment->kind,
                  "file", file, "axes", result_json_take_list(result_study_axes(study)), "spreads",
                  result_json_take_list(result_study_spreads(study)), "passes", make_passes(study), "runs",
                  (json_int_t)study->runs, "seed", (json_int_t)study->seed);
    result_json_take_record(answer, result_study_counts(study));
    set(answer, "ranges", result_json_take_list(result_study_ranges(study)));
    if (study->axis_count == 1 && study->pass_count > 1)
        set(answer, "passes_differ_at", make_differences(study));
    if (study->experiment->note)
        set(answer, "grades", result_json_take_list(study_grades_table(study)));
    set(answer, "best", make_extreme(study, false));
    set(answer, "worst", make_extreme(study, true));
    if (basins_exist(study))
        set(answer, "basins", make_basins(study));
    if (!study->axis_count && study->runs > 1)
        set(answer, "distribution", make_distributions(study));
    set(answer, "digest", json_string(digest));
    return answer;
}
