#include "result/study.h"

#include <stdint.h>
#include <string.h>

#include "base/text.h"
#include "result/study_grades.h"
#include "result/study_number.h"
#include "study/montecarlo.h"

/* The words for one kind of experiment. */
typedef struct Words {
    const char *kind;
    const char *hidden;                        /* an observable that only distinguishes runs; "": none */
    const char *states[SUMMARY_UNDECIDED + 1]; /* by SummaryState */
} Words;

static const Words all_words[] = {
    {"beam", "", {"not run", "periodic", "not periodic", "sometimes periodic", "undecided"}},
    {"house", "way", {"not run", "out", "not out", "sometimes out", "undecided"}},
};
enum { KINDS = sizeof all_words / sizeof *all_words };

static const Words *find_words(const Experiment *experiment) {
    for (size_t k = 0; k < KINDS; k++)
        if (strcmp(all_words[k].kind, experiment->kind) == 0)
            return &all_words[k];
    return &all_words[0];
}

const char *result_study_state(const Experiment *experiment, SummaryState state) {
    return find_words(experiment)->states[state];
}

bool result_study_is_shown(const Study *study, size_t observable) {
    const Experiment *experiment = study->experiment;
    const char *name = experiment->observables[observable].name, *hidden = find_words(experiment)->hidden;
    bool verdict = experiment->verdict_count && observable == experiment->verdict;
    bool words = verdict || (experiment->rank_count && observable == experiment->rank);
    if (observable == experiment->regular || words || strcmp(name, hidden) == 0)
        return false;
    bool any = false;
    for (size_t t = 0; t < study->trial_count && !any; t++)
        any = !isnan(study_nth(study, t)->observed[observable]);
    return any;
}

static const char *axis_value(Arena *arena, const Study *study, size_t axis, double value, bool with_unit) {
    char word[STUDY_NUMBER];
    study_number_value(study, axis, value, with_unit, word);
    return arena_text(arena, word);
}

static const char *unit_of(const Study *study, const char *name) {
    return study->experiment->parameter(study->experiment->given, name)->unit;
}

/* The unit of a number for people; NULL for a pure number. */
static const char *read_unit(const Observable *observable) {
    const char *unit = study_number_unit(observable);
    return *unit ? unit : NULL;
}

/* An observed number, which people read with four digits; its label is given by the caller. */
static ResultRow observed(Arena *arena, double number) {
    char word[STUDY_NUMBER];
    study_number_observed(number, word);
    return (ResultRow){.kind = RESULT_NUMBER, .number = number, .text = isnan(number) ? NULL : arena_text(arena, word)};
}

/* The question ---------------------------------------------------------------------------------------------------- */

static void add_end(ResultTable *table, const Study *study, size_t a, const char *name, double value) {
    result_add(table, (ResultRow){.key = name,
                                  .label = name,
                                  .kind = RESULT_NUMBER,
                                  .number = value,
                                  .text = axis_value(&table->arena, study, a, value, true)});
}

ResultTable result_study_axes(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t a = 0; a < study->axis_count; a++) {
        const StudyAxis *axis = &study->axes[a];
        result_add(&table, (ResultRow){.key = "name", .label = "parameter", .text = axis->name});
        result_add(&table, (ResultRow){.key = "unit", .text = unit_of(study, axis->name)});
        add_end(&table, study, a, "from", axis->from);
        add_end(&table, study, a, "to", axis->to);
        result_add(&table,
                   (ResultRow){.key = "steps", .label = "steps", .kind = RESULT_COUNT, .number = (double)axis->steps});
        result_end(&table);
    }
    return table;
}

ResultTable result_study_spreads(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t s = 0; s < study->spread_count; s++) {
        double share = study->spreads[s].share;
        result_add(&table, (ResultRow){.key = "name", .label = "parameter", .text = study->spreads[s].name});
        result_add(&table, (ResultRow){.key = "share",
                                       .label = "standard deviation",
                                       .kind = RESULT_NUMBER,
                                       .number = share,
                                       .text = text_in_arena(&table.arena, "%g", 100 * share),
                                       .unit = "%"});
        result_end(&table);
    }
    return table;
}

/* The answer ------------------------------------------------------------------------------------------------------ */

static const char *first_fault(const Study *study) {
    for (size_t t = 0; t < study->trial_count; t++)
        if (study_nth(study, t)->fault)
            return study_nth(study, t)->fault;
    return NULL;
}

static void add_count(ResultTable *table, const char *key, const char *label, size_t count) {
    result_add(table, (ResultRow){.key = key, .label = label, .kind = RESULT_COUNT, .number = (double)count});
}

/* Adds how many runs have which verdict; those of quick runs say so. */
static void add_verdicts(ResultTable *table, const Study *study) {
    const Experiment *experiment = study->experiment;
    size_t *counts = summary_verdicts(study);
    for (size_t v = 0; counts && v < experiment->verdict_count; v++) {
        bool quick = v >= experiment->verdict_quick;
        if (counts[v])
            add_count(table, text_in_arena(&table->arena, "verdicts.%s", experiment->verdicts[v]),
                      text_in_arena(&table->arena, quick ? "%s (quick verdict)" : "%s", experiment->verdicts[v]),
                      counts[v]);
    }
    memory_free(counts);
}

ResultTable result_study_counts(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const Experiment *experiment = study->experiment;
    const Observable *regular = &experiment->observables[experiment->regular],
                     *measure = &experiment->observables[experiment->measure];
    const Words *words = find_words(experiment);
    SummaryCount count = summary_count(study);
    add_count(&table, "trials", "runs", count.trials);
    add_count(&table, "done", "done", count.done);
    add_count(&table, "faults", "impossible", count.faults);
    result_add(&table, (ResultRow){.key = "first_fault", .label = "first reason", .text = first_fault(study)});
    add_count(&table, "regular", words->states[SUMMARY_REGULAR], count.regular);
    add_count(&table, "not_regular", words->states[SUMMARY_IRREGULAR], count.irregular);
    add_count(&table, "cannot_be_told", words->states[SUMMARY_UNDECIDED], count.undecided);
    add_verdicts(&table, study);
    result_add(&table, (ResultRow){.key = "regular_means", .text = regular->meaning});
    result_add(&table, (ResultRow){.key = "measure.name", .text = measure->name});
    result_add(&table, (ResultRow){.key = "measure.unit", .text = measure->unit});
    result_add(&table, (ResultRow){.key = "measure.meaning", .label = "measure", .text = measure->meaning});
    result_end(&table);
    return table;
}

static void add_range(ResultTable *table, const Study *study, size_t pass, size_t a, const SummaryRange *range) {
    const StudyAxis *axis = &study->axes[a];
    result_add(table, (ResultRow){.key = "pass", .label = "pass", .text = study_pass_name(study->passes[pass])});
    result_add(table, (ResultRow){.key = "name", .label = "parameter", .text = axis->name});
    add_end(table, study, a, "from", study_value(axis, range->first));
    add_end(table, study, a, "to", study_value(axis, range->last));
    add_count(table, "steps", "steps", range->last - range->first + 1);
    result_add(table, (ResultRow){.key = "answer", .text = summary_state_name(range->state)});
    result_add(table, (ResultRow){.label = "answer", .text = result_study_state(study->experiment, range->state)});
    result_end(table);
}

ResultTable result_study_ranges(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t a = 0; a < study->axis_count; a++) {
            size_t count;
            SummaryRange *ranges = summary_ranges(study, pass, a, &count);
            for (size_t r = 0; r < count; r++)
                add_range(&table, study, pass, a, &ranges[r]);
            memory_free(ranges);
        }
    return table;
}

ResultTable result_study_extreme(const Study *study, bool greatest) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const Experiment *experiment = study->experiment;
    size_t index = summary_extreme(study, greatest);
    if (index == SIZE_MAX)
        return table;
    const Trial *trial = study_nth(study, index);
    ResultRow value = observed(&table.arena, trial->observed[experiment->measure]);
    value.key = "value";
    value.label = greatest ? "greatest" : "least";
    value.unit = read_unit(&experiment->observables[experiment->measure]);
    result_add(&table, value);
    for (size_t n = 0; n < study->name_count; n++) {
        bool axis = n < study->axis_count;
        result_add(&table, (ResultRow){.key = text_in_arena(&table.arena, "at.%s", study->names[n]),
                                       .label = axis ? study->names[n] : NULL,
                                       .kind = RESULT_NUMBER,
                                       .number = trial->at[n],
                                       .text = axis ? axis_value(&table.arena, study, n, trial->at[n], true) : NULL});
    }
    result_add(&table, (ResultRow){.key = "pass",
                                   .label = study->pass_count > 1 ? "pass" : NULL,
                                   .text = study_pass_name(study->passes[study_pass_of(study, index)])});
    result_end(&table);
    return table;
}

/* Points ---------------------------------------------------------------------------------------------------------- */

static void add_grade(ResultTable *table, const Study *study, size_t i) {
    result_add(table, (ResultRow){.label = "grade", .text = study_grades_letter(study, 0, i)});
}

static void add_run(ResultTable *table, const Study *study, size_t pass, size_t i) {
    const Experiment *experiment = study->experiment;
    const Trial *trial = study_trial(study, pass, 0, 0, i);
    const char *verdict = trial->fault ? NULL : trial_verdict(trial, experiment);
    result_add(table, (ResultRow){.label = "answer",
                                  .text = verdict ? verdict
                                                  : result_study_state(experiment, summary_point(study, pass, 0, i))});
    add_grade(table, study, i);
    for (size_t o = 0; o < experiment->observable_count; o++) {
        if (!result_study_is_shown(study, o))
            continue;
        ResultRow row = observed(&table->arena, trial->observed[o]);
        row.label = experiment->observables[o].name;
        row.unit = read_unit(&experiment->observables[o]);
        result_add(table, row);
    }
}

/* True if each point has runs enough for quantiles of 5 and 95 %. */
static bool has_band(const Study *study) {
    return study->runs >= MONTECARLO_BAND;
}

static void add_runs(ResultTable *table, const Study *study, size_t pass, size_t i) {
    const Experiment *experiment = study->experiment;
    const Observable *measure = &experiment->observables[experiment->measure];
    MontecarloPoint point = montecarlo_point(study, pass, 0, i);
    const Distribution *d = &point.of[experiment->measure];
    const struct {
        const char *name;
        double number;
    } columns[] = {{NULL, d->mean},
                   {"deviation", d->deviation},
                   {has_band(study) ? "5 %" : "least", has_band(study) ? d->low : d->least},
                   {"50 %", d->median},
                   {has_band(study) ? "95 %" : "greatest", has_band(study) ? d->high : d->greatest}};
    result_add(table, (ResultRow){.label = result_study_state(experiment, SUMMARY_REGULAR),
                                  .kind = RESULT_NUMBER,
                                  .number = point.share,
                                  .unit = "%",
                                  .factor = 100});
    add_grade(table, study, i);
    for (size_t c = 0; c < sizeof columns / sizeof *columns; c++) {
        ResultRow row = observed(&table->arena, columns[c].number);
        row.label = c ? columns[c].name : text_in_arena(&table->arena, "mean %s", measure->name);
        row.unit = c ? NULL : read_unit(measure);
        result_add(table, row);
    }
    montecarlo_clear(&point);
}

ResultTable result_study_points(const Study *study, const bool *chosen) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const char *unit = study_number_axis_unit(study, 0);
    for (size_t i = 0; i < study_steps(study, 0); i++)
        for (size_t pass = 0; pass < study->pass_count && chosen[i]; pass++) {
            double value = study_value(&study->axes[0], i);
            result_add(&table, (ResultRow){.label = study->axes[0].name,
                                           .kind = RESULT_NUMBER,
                                           .number = value,
                                           .text = axis_value(&table.arena, study, 0, value, false),
                                           .unit = *unit ? unit : NULL});
            if (study->pass_count > 1)
                result_add(&table, (ResultRow){.label = "pass", .text = study_pass_name(study->passes[pass])});
            (study->runs > 1 ? add_runs : add_run)(&table, study, pass, i);
            result_end(&table);
        }
    return table;
}

/* Runs at one point ----------------------------------------------------------------------------------------------- */

static void add_share(ResultTable *table, const char *key, const char *label, double share) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = share,
                                  .unit = "%",
                                  .factor = 100,
                                  .decimals = 1});
}

ResultTable result_study_share(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    MontecarloPoint point = montecarlo_point(study, 0, 0, 0);
    add_share(&table, "value", result_study_state(study->experiment, SUMMARY_REGULAR), point.share);
    add_share(&table, "q025", "at least, with 97.5 % confidence", point.share_low);
    add_share(&table, "q975", "at most, with 97.5 % confidence", point.share_high);
    result_end(&table);
    montecarlo_clear(&point);
    return table;
}

static void add_number(ResultTable *table, const char *key, const char *label, double number) {
    ResultRow row = observed(&table->arena, number);
    row.key = key;
    row.label = label;
    result_add(table, row);
}

ResultTable result_study_distributions(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    MontecarloPoint point = montecarlo_point(study, 0, 0, 0);
    for (size_t o = 0; o < point.observables; o++) {
        if (summary_is_class(study->experiment, o))
            continue;
        const Observable *observable = &study->experiment->observables[o];
        const Distribution *d = &point.of[o];
        result_add(&table, (ResultRow){.label = "observable", .text = observable->name});
        result_add(&table, (ResultRow){.key = "unit", .text = observable->unit});
        result_add(&table, (ResultRow){.label = "unit", .text = study_number_unit(observable)});
        result_add(&table, (ResultRow){.key = "count", .kind = RESULT_COUNT, .number = (double)d->count});
        add_number(&table, "mean", "mean", d->mean);
        add_number(&table, "deviation", "deviation", d->deviation);
        add_number(&table, "standard_error", "std error", d->error);
        add_number(&table, "q05", has_band(study) ? "5 %" : NULL, d->low);
        add_number(&table, "q50", "50 %", d->median);
        add_number(&table, "q95", has_band(study) ? "95 %" : NULL, d->high);
        add_number(&table, "least", "least", d->least);
        add_number(&table, "greatest", "greatest", d->greatest);
        result_end(&table);
    }
    montecarlo_clear(&point);
    return table;
}
