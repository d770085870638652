#include "command/study_text.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "result/study.h"
#include "result/study_grades.h"
#include "result/study_number.h"
#include "result/text.h"
#include "study/basins.h"
#include "study/montecarlo.h"

enum {
    WORD = STUDY_NUMBER,
    RANGES_MOST = 6,  /* ranges that are listed one by one */
    ROWS_MOST = 12,   /* rows of the table */
    CHANGES_MOST = 5, /* changes whose two sides are among the rows */
    MAP_COLUMNS = 72, /* characters of a map */
    MAP_ROWS = 24,
};

/* Phrases ---------------------------------------------------------------------------------------------------------- */

/* Where an answer holds, as it is said. */
typedef struct RangePhrases {
    const char *throughout;
    const char *up_to;   /* last value */
    const char *from_on; /* first value */
    const char *at;      /* the only value */
    const char *from_to; /* first and last value */
} RangePhrases;

/* The phrases about one kind of experiment. */
typedef struct Phrases {
    const char *kind;
    RangePhrases ranges[SUMMARY_UNDECIDED + 1]; /* by SummaryState */
    const char *runs;                           /* number of regular runs, number of all */
    const char *runs_undecided;                 /* number of regular runs, number of all, number of undecided runs */
    const char *values;                         /* number of values with regular runs, number of all */
    const char *share; /* number of regular runs, number of all, share, its least and its most, in % */
} Phrases;

#define NOT_RUN                                                                                                        \
    { "not run throughout", "not run up to %s", "not run from %s on", "not run at %s", "not run from %s to %s" }
#define UNDECIDED                                                                                                      \
    {                                                                                                                  \
        "undecided throughout", "undecided up to %s", "undecided from %s on", "undecided at %s",                       \
            "undecided from %s to %s"                                                                                  \
    }

static const Phrases all_phrases[] = {
    {.kind = "beam",
     .ranges = {NOT_RUN,
                {"periodic throughout", "periodic up to %s", "periodic from %s on", "periodic at %s",
                 "periodic from %s to %s"},
                {"not periodic throughout", "not periodic up to %s", "not periodic from %s on", "not periodic at %s",
                 "not periodic from %s to %s"},
                {"sometimes periodic throughout", "sometimes periodic up to %s", "sometimes periodic from %s on",
                 "sometimes periodic at %s", "sometimes periodic from %s to %s"},
                UNDECIDED},
     .runs = "periodic in %zu of %zu runs",
     .runs_undecided = "periodic in %zu of %zu runs, undecided in %zu",
     .values = "periodic at %zu of %zu values",
     .share = "periodic in %zu of %zu runs: %.1f %%, with 95 %% confidence from %.1f to %.1f %%"},
    {.kind = "house",
     .ranges = {NOT_RUN,
                {"out throughout", "out up to %s", "out from %s on", "out at %s", "out from %s to %s"},
                {"not out throughout", "not out up to %s", "not out from %s on", "not out at %s",
                 "not out from %s to %s"},
                {"sometimes out throughout", "sometimes out up to %s", "sometimes out from %s on",
                 "sometimes out at %s", "sometimes out from %s to %s"},
                UNDECIDED},
     .runs = "out in %zu of %zu runs",
     .runs_undecided = "out in %zu of %zu runs, undecided in %zu",
     .values = "out at %zu of %zu values",
     .share = "out in %zu of %zu runs: %.1f %%, with 95 %% confidence from %.1f to %.1f %%"},
    {.kind = "drivers",
     .ranges = {NOT_RUN,
                {"all out throughout", "all out up to %s", "all out from %s on", "all out at %s",
                 "all out from %s to %s"},
                {"none out throughout", "none out up to %s", "none out from %s on", "none out at %s",
                 "none out from %s to %s"},
                {"some out throughout", "some out up to %s", "some out from %s on", "some out at %s",
                 "some out from %s to %s"},
                UNDECIDED},
     .runs = "%zu of %zu drivers out",
     .runs_undecided = "%zu of %zu drivers out, %zu undecided",
     .values = "drivers out at %zu of %zu values",
     .share = "%zu of %zu drivers out: %.1f %%, with 95 %% confidence from %.1f to %.1f %%"},
};
enum { KINDS = sizeof all_phrases / sizeof *all_phrases };

static const Phrases *find_phrases(const Study *study) {
    const char *kind = study->experiment->chance ? study->experiment->chance : study->experiment->kind;
    for (size_t k = 0; k < KINDS; k++)
        if (strcmp(all_phrases[k].kind, kind) == 0)
            return &all_phrases[k];
    return &all_phrases[0];
}

/* The question ----------------------------------------------------------------------------------------------------- */

static void add_axis(Text *text, const Study *study, size_t a) {
    char from[WORD], to[WORD];
    size_t steps = study->axes[a].steps;
    study_number_step(study, a, 0, steps == 1, from);
    study_number_step(study, a, steps - 1, true, to);
    if (steps == 1)
        text_format(text, "%s at %s\n", study->axes[a].name, from);
    else if (experiment_turns(study->experiment, study->axes[a].name))
        text_format(text, "%s from %s to %s (%.4g to %.4g Hz) in %zu steps\n", study->axes[a].name, from, to,
                    study->axes[a].from, study->axes[a].to, steps);
    else
        text_format(text, "%s from %s to %s in %zu steps\n", study->axes[a].name, from, to, steps);
}

static void add_question(Text *text, const Study *study, const char *file) {
    uint64_t last = study->seed + study->runs - 1;
    text_format(text, "%s: ", file);
    for (size_t a = 0; a < study->axis_count; a++)
        add_axis(text, study, a);
    const char *chance = study->experiment->chance;
    if (chance)
        text_format(text, study->axis_count ? "%zu %s at each point\n" : "%zu %s\n", study->runs, chance);
    else if (study->experiment->carries && study->seed && study->runs > 1) /* of a motion each seed is a start */
        text_format(text, "%zu random starts%s, seeds %" PRIu64 " to %" PRIu64 "\n", study->runs,
                    study->axis_count ? " at each value" : "", study->seed, last);
    else if (!study->axis_count)
        text_format(text, "%zu runs, seeds %" PRIu64 " to %" PRIu64 "\n", study->runs, study->seed, last);
    else if (study->runs > 1)
        text_format(text, "%zu runs of each, seeds %" PRIu64 " to %" PRIu64 "\n", study->runs, study->seed, last);
    for (size_t s = 0; s < study->spread_count; s++)
        text_format(text, "%s with a standard deviation of %g %%\n", study->spreads[s].name,
                    100 * study->spreads[s].share);
}

/* Answers along an axis -------------------------------------------------------------------------------------------- */

/* Adds a range: "not out up to 0.83 m", "out from 0.84 m on". */
static void add_range(Text *text, const Study *study, size_t axis, const SummaryRange *range) {
    const RangePhrases *phrases = &find_phrases(study)->ranges[range->state];
    size_t last = study->axes[axis].steps - 1;
    char from[WORD], to[WORD];
    study_number_step(study, axis, range->first, range->first == range->last || range->last == last, from);
    study_number_step(study, axis, range->last, true, to);
    if (range->first == 0 && range->last == last)
        text_add(text, phrases->throughout);
    else if (range->first == 0 && range->last > 0)
        text_format(text, phrases->up_to, to);
    else if (range->last == last && range->first < last)
        text_format(text, phrases->from_on, from);
    else if (range->first == range->last)
        text_format(text, phrases->at, from);
    else
        text_format(text, phrases->from_to, from, to);
}

/* Returns the longest range of a state, or NULL. */
static const SummaryRange *longest(const SummaryRange *ranges, size_t count, SummaryState state) {
    const SummaryRange *found = NULL;
    for (size_t r = 0; r < count; r++)
        if (ranges[r].state == state && (!found || ranges[r].last - ranges[r].first > found->last - found->first))
            found = &ranges[r];
    return found;
}

static size_t values_of(const SummaryRange *ranges, size_t count, SummaryState state) {
    size_t values = 0;
    for (size_t r = 0; r < count; r++)
        values += ranges[r].state == state ? ranges[r].last - ranges[r].first + 1 : 0;
    return values;
}

/* Adds how many values have which answer, how often it changes, and where it lasts longest. */
static void add_many_ranges(Text *text, const Study *study, size_t axis, const SummaryRange *ranges, size_t count) {
    size_t regular = values_of(ranges, count, SUMMARY_REGULAR), undecided = values_of(ranges, count, SUMMARY_UNDECIDED);
    text_format(text, find_phrases(study)->values, regular, study->axes[axis].steps);
    if (undecided)
        text_format(text, "; undecided at %zu of them", undecided);
    text_format(text, "; the answer changes %zu times", count - 1);
    for (SummaryState state = SUMMARY_REGULAR; state <= SUMMARY_IRREGULAR; state++) {
        const SummaryRange *range = longest(ranges, count, state);
        if (!range)
            continue;
        text_add(text, "; longest ");
        add_range(text, study, axis, range);
    }
}

static void add_ranges(Text *text, const Study *study, size_t pass, size_t axis) {
    size_t count;
    SummaryRange *ranges = summary_ranges(study, pass, axis, &count);
    if (count > RANGES_MOST)
        add_many_ranges(text, study, axis, ranges, count);
    for (size_t r = 0; r < count && count <= RANGES_MOST; r++) {
        text_add(text, r ? ", " : "");
        add_range(text, study, axis, &ranges[r]);
    }
    memory_free(ranges);
}

/* 1, share of the range of a measure: smaller changes are not reported. */
#define RIPPLE 1e-3

/* How the measure changes along the only axis. */
typedef struct Course {
    size_t first, last, least, greatest; /* steps; SIZE_MAX: no step has the measure */
    bool falls, rises;
} Course;

static double mean_measure(const Study *study, size_t pass, size_t i) {
    MontecarloPoint point = montecarlo_point(study, pass, 0, i);
    double mean = point.of[study->experiment->measure].mean;
    montecarlo_clear(&point);
    return mean;
}

static Course follow_course(const Study *study, size_t pass) {
    Course course = {.first = SIZE_MAX};
    double least = HUGE_VAL, greatest = -HUGE_VAL, rise = 0, fall = 0;
    for (size_t i = 0; i < study_steps(study, 0); i++) {
        double mean = mean_measure(study, pass, i);
        if (isnan(mean))
            continue;
        course.first = course.first < SIZE_MAX ? course.first : i;
        course.least = mean < least ? i : course.least;
        course.greatest = mean > greatest ? i : course.greatest;
        course.last = i;
        least = fmin(least, mean);
        greatest = fmax(greatest, mean);
        rise = fmax(rise, mean - least);
        fall = fmax(fall, greatest - mean);
    }
    course.falls = rise <= RIPPLE * (greatest - least);
    course.rises = fall <= RIPPLE * (greatest - least);
    return course;
}

/* Writes the mean measure at a step: "31.2 s". */
static void write_measure(const Study *study, size_t pass, size_t i, bool with_unit, char word[WORD]) {
    const char *unit = study_number_unit(&study->experiment->observables[study->experiment->measure]);
    study_number_observed(mean_measure(study, pass, i), word);
    if (with_unit && *unit)
        snprintf(word + strlen(word), WORD - strlen(word), " %.15s", unit);
}

/* A value of the measure, and where it is. */
typedef struct Extreme {
    bool between; /* at none of the ends */
    char value[WORD], at[WORD];
} Extreme;

static Extreme find_extreme(const Study *study, size_t pass, const Course *course, size_t i) {
    Extreme extreme = {.between = i != course->first && i != course->last};
    write_measure(study, pass, i, true, extreme.value);
    study_number_step(study, 0, i, true, extreme.at);
    return extreme;
}

/* Adds whether the measure falls, rises, or has a least and a greatest value in between. */
static void add_course(Text *text, const Study *study, size_t pass) {
    const char *measure = study->experiment->observables[study->experiment->measure].meaning;
    Course course = follow_course(study, pass);
    if (course.first == SIZE_MAX)
        return;
    char first[WORD], last[WORD];
    write_measure(study, pass, course.first, false, first);
    write_measure(study, pass, course.last, true, last);
    Extreme least = find_extreme(study, pass, &course, course.least);
    Extreme greatest = find_extreme(study, pass, &course, course.greatest);
    text_add(text, "; ");
    if (course.falls && course.rises)
        text_format(text, "the %s is %s", measure, last);
    else if (course.falls)
        text_format(text, "the %s falls from %s to %s", measure, first, last);
    else if (course.rises)
        text_format(text, "the %s rises from %s to %s", measure, first, last);
    else if (least.between && greatest.between)
        text_format(text, "the %s goes from %s to %s, least %s at %s, greatest %s at %s", measure, first, last,
                    least.value, least.at, greatest.value, greatest.at);
    else if (least.between)
        text_format(text, "the %s goes from %s to %s, least %s at %s", measure, first, last, least.value, least.at);
    else
        text_format(text, "the %s goes from %s to %s, greatest %s at %s", measure, first, last, greatest.value,
                    greatest.at);
}

static void add_answers(Text *text, const Study *study) {
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t a = 0; a < study->axis_count; a++) {
            if (study->pass_count > 1)
                text_format(text, "%s: ", study_pass_name(study->passes[pass]));
            if (study->axis_count == 2)
                text_format(text, "along %s: ", study->axes[a].name);
            add_ranges(text, study, pass, a);
            if (study->axis_count == 1)
                add_course(text, study, pass);
            text_add(text, "\n");
        }
}

/* Adds where passes end in different answers. */
static void add_differences(Text *text, const Study *study) {
    size_t count = 0, first = 0;
    for (size_t i = study_steps(study, 0); i-- > 0;)
        if (summary_passes_differ(study, 0, i)) {
            count++;
            first = i;
        }
    char at[WORD];
    study_number_step(study, 0, first, true, at);
    if (count)
        text_format(text,
                    "at %zu of %zu values, the first %s, the passes end in different answers: it depends on the past\n",
                    count, study_steps(study, 0), at);
}

/* Adds how many values have several answers, what random starts miss, and what they cannot see. */
static void add_basins(Text *text, const Study *study) {
    size_t several = 0, missed = 0, first = SIZE_MAX, starts = 0;
    double unseen = 0;
    for (size_t i = 0; i < study_steps(study, 0); i++) {
        Basins basins = basins_at(study, i);
        bool misses = false;
        for (size_t k = 0; k < basins.count; k++)
            misses |= !basins.of[k].share.good;
        several += basins.count > 1;
        missed += misses;
        first = misses && first == SIZE_MAX ? i : first;
        starts = i && basins.starts > starts ? starts : basins.starts;
        unseen = fmax(unseen, basins.unseen_below);
    }
    text_format(text,
                "basins: several motions at %zu of %zu values; after %zu starts without it, the basin of another "
                "motion has a share below %.0f %% (95 %%)\n",
                several, study_steps(study, 0), starts, 100 * unseen);
    char at[WORD];
    if (!missed)
        return;
    study_number_step(study, 0, first, true, at);
    text_format(text,
                "at %zu values, the first %s, another start reaches a motion that no random one does: a sweep, or the "
                "motion without contact\n",
                missed, at);
}

/* Tables ----------------------------------------------------------------------------------------------------------- */

/* Chooses the rows to show: both ends, both sides of each change while there is room, and others evenly in between. */
static void choose_rows(const Study *study, bool *chosen) {
    size_t steps = study_steps(study, 0), most = ROWS_MOST / (study->pass_count + 1) * 2, count;
    size_t rows = steps < most ? steps : most;
    for (size_t r = 0; r < rows; r++)
        chosen[rows > 1 ? r * (steps - 1) / (rows - 1) : 0] = true;
    SummaryRange *ranges = summary_ranges(study, 0, 0, &count);
    for (size_t r = 1; r < count && count <= CHANGES_MOST + 1 && study->pass_count == 1; r++)
        chosen[ranges[r].first] = chosen[ranges[r].first - 1] = true;
    memory_free(ranges);
}

static void add_points(Text *text, const Study *study) {
    size_t steps = study_steps(study, 0), shown = 0;
    bool *chosen = memory_zeroed(steps, sizeof *chosen);
    choose_rows(study, chosen);
    result_text_take(text, "", result_study_points(study, chosen));
    for (size_t i0 = 0; i0 < steps; i0++)
        shown += chosen[i0];
    if (shown < steps)
        text_format(text, "%zu of %zu steps are shown; --out writes the table of all\n", shown, steps);
    memory_free(chosen);
}

/* True if tables show the observable of this name. */
static bool is_named_shown(const Study *study, const char *name) {
    for (size_t o = 0; o < study->experiment->observable_count; o++)
        if (strcmp(study->experiment->observables[o].name, name) == 0)
            return result_study_is_shown(study, o);
    return false;
}

/* Adds the distributions of the observables that tables show. */
static void add_distributions(Text *text, const Study *study) {
    ResultTable all = result_study_distributions(study), shown = {.numbers = all.numbers};
    for (size_t o = 0; o < all.record_count; o++) {
        if (!is_named_shown(study, result_at(&all, o, 0)->text))
            continue;
        for (size_t r = 0; r < all.row_count; r++)
            result_add(&shown, *result_at(&all, o, r));
        result_end(&shown);
    }
    result_text_take(text, "", shown);
    result_clear(&all);
}

/* Maps ------------------------------------------------------------------------------------------------------------- */

static const char letters[] = {[SUMMARY_NOTHING] = ' ',
                               [SUMMARY_REGULAR] = '#',
                               [SUMMARY_IRREGULAR] = '.',
                               [SUMMARY_MIXED] = '+',
                               [SUMMARY_UNDECIDED] = '?'};

/* Returns the letter of a cell: of its grade, if all are out and have one. */
static char letter_at(const Study *study, size_t pass, size_t i1, size_t i0) {
    SummaryState state = summary_point(study, pass, i1, i0);
    const char *grade = state == SUMMARY_REGULAR ? study_grades_letter(study, i1, i0) : NULL;
    return grade ? *grade : letters[state];
}

static void add_legend(Text *text, const Study *study) {
    SummaryCount count = summary_count(study);
    const bool occurs[] = {[SUMMARY_REGULAR] = true,
                           [SUMMARY_IRREGULAR] = true,
                           [SUMMARY_MIXED] = study->runs > 1,
                           [SUMMARY_UNDECIDED] = count.undecided};
    bool graded = study_grades_exist(study);
    if (graded)
        text_format(text, "\nA to F %s with that grade", result_study_state(study->experiment, SUMMARY_REGULAR));
    for (SummaryState state = graded ? SUMMARY_IRREGULAR : SUMMARY_REGULAR; state <= SUMMARY_UNDECIDED; state++)
        if (occurs[state])
            text_format(text, "%s%c %s", state == SUMMARY_REGULAR ? "\n" : ", ", letters[state],
                        result_study_state(study->experiment, state));
    if (count.faults || count.done < count.trials)
        text_add(text, ", blank: not run");
    text_format(text, "\nto the right %s, upwards %s\n", study->axes[0].name, study->axes[1].name);
}

static void add_map(Text *text, const Study *study, size_t pass) {
    size_t steps0 = study_steps(study, 0), steps1 = study_steps(study, 1);
    size_t columns = steps0 < MAP_COLUMNS ? steps0 : MAP_COLUMNS, rows = steps1 < MAP_ROWS ? steps1 : MAP_ROWS;
    add_legend(text, study);
    for (size_t r = rows; r-- > 0;) {
        size_t i1 = rows > 1 ? r * (steps1 - 1) / (rows - 1) : 0;
        char value[WORD], line[MAP_COLUMNS + 1];
        study_number_step(study, 1, i1, false, value);
        for (size_t c = 0; c < columns; c++)
            line[c] = letter_at(study, pass, i1, columns > 1 ? c * (steps0 - 1) / (columns - 1) : 0);
        line[columns] = 0;
        text_format(text, "%10s %s\n", value, line);
    }
    char from[WORD], to[WORD];
    study_number_step(study, 0, 0, false, from);
    study_number_step(study, 0, steps0 - 1, true, to);
    text_format(text, "%10s %s to %s\n", "", from, to);
}

/* Adds where the measure is least and where it is greatest. */
static void add_extremes(Text *text, const Study *study) {
    const char *measure = study->experiment->observables[study->experiment->measure].meaning;
    ResultTable least = result_study_extreme(study, false), greatest = result_study_extreme(study, true);
    if (least.record_count) {
        const char *value = result_value_and_unit(result_at(&least, 0, 0), &least.arena);
        text_format(text, "the %s is least, %s, at %s %s and %s %s\n", measure, value, study->axes[0].name,
                    result_at(&least, 0, 1)->text, study->axes[1].name, result_at(&least, 0, 2)->text);
        value = result_value_and_unit(result_at(&greatest, 0, 0), &greatest.arena);
        text_format(text, "the %s is greatest, %s, at %s %s and %s %s\n", measure, value, study->axes[0].name,
                    result_at(&greatest, 0, 1)->text, study->axes[1].name, result_at(&greatest, 0, 2)->text);
    }
    result_clear(&least);
    result_clear(&greatest);
}

/* The whole -------------------------------------------------------------------------------------------------------- */

static void add_faults(Text *text, const Study *study, size_t faults) {
    size_t t = 0;
    while (t < study->trial_count && !study_nth(study, t)->fault)
        t++;
    if (t < study->trial_count && faults == 1)
        text_format(text, "one run could not be made: %s\n", study_nth(study, t)->fault);
    else if (t < study->trial_count)
        text_format(text, "%zu runs could not be made; the first: %s\n", faults, study_nth(study, t)->fault);
}

static void add_share(Text *text, const Study *study) {
    MontecarloPoint point = montecarlo_point(study, 0, 0, 0);
    if (point.decided) {
        text_format(text, find_phrases(study)->share, point.regular, point.decided, 100 * point.share,
                    100 * point.share_low, 100 * point.share_high);
        text_add(text, "\n");
    }
    if (point.done > 1 && point.of[study->experiment->measure].deviation == 0)
        text_add(text,
                 "all runs are alike, since nothing in them is random; give a tolerance with --spread NAME=SHARE\n");
    montecarlo_clear(&point);
}

static void add_count(Text *text, const Study *study, const SummaryCount *count) {
    const Phrases *phrases = find_phrases(study);
    text_format(text, count->undecided ? phrases->runs_undecided : phrases->runs, count->regular,
                count->done - count->faults, count->undecided);
    text_add(text, "\n");
}

/* Adds how many runs have which verdict: "motion: 190 periodic, 60 not periodic (quick verdict)". */
static void add_verdicts(Text *text, const Study *study) {
    const Experiment *experiment = study->experiment;
    size_t *counts = summary_verdicts(study), named = 0, quick = 0;
    for (size_t v = 0; counts && v < experiment->verdict_count; v++) {
        if (!counts[v])
            continue;
        bool is_quick = v >= experiment->verdict_quick;
        text_format(text, is_quick ? "%s%zu %s (quick verdict)" : "%s%zu %s", named++ ? ", " : "of all runs ",
                    counts[v], experiment->verdicts[v]);
        quick += is_quick ? counts[v] : 0;
    }
    if (named)
        text_add(text, quick ? "; --thorough tells what those are\n" : "\n");
    memory_free(counts);
}

void study_text_add(Text *text, const Study *study, const char *file) {
    SummaryCount count = summary_count(study);
    if (count.done < study_room(study))
        text_format(text, "interrupted after %zu of %zu runs; only these are told\n", count.done, study_room(study));
    add_question(text, study, file);
    if (study->axis_count == 0)
        add_share(text, study);
    if (study->axis_count == 2)
        add_count(text, study, &count);
    add_answers(text, study);
    add_verdicts(text, study);
    if (study->axis_count == 1)
        add_differences(text, study);
    study_grades_say(text, study);
    if (basins_exist(study))
        add_basins(text, study);
    if (study->axis_count == 2) {
        add_extremes(text, study);
        for (size_t pass = 0; pass < study->pass_count; pass++)
            add_map(text, study, pass);
    } else if (study->axis_count == 1) {
        add_points(text, study);
    } else {
        add_distributions(text, study);
    }
    if (count.faults)
        add_faults(text, study, count.faults);
}
