#include "command/study_text.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "command/study_number.h"
#include "study/montecarlo.h"
#include "study/summary.h"

enum {
    WORD = STUDY_NUMBER,
    RANGES_MOST = 6,  /* ranges that are listed one by one */
    ROWS_MOST = 12,   /* rows of the table */
    CHANGES_MOST = 5, /* changes whose two sides are among the rows */
    MAP_COLUMNS = 72, /* characters of a map */
    MAP_ROWS = 24,
};

/* Sentences ------------------------------------------------------------------------------------------------------ */

static void print_title(const Study *study, const char *file) {
    printf("%s", file);
    for (size_t a = 0; a < study->axis_count; a++) {
        char from[WORD], to[WORD];
        study_number_step(study, a, 0, false, from);
        study_number_step(study, a, study->axes[a].steps - 1, true, to);
        printf("%s %s from %s to %s in ", a ? "," : ":", study->axes[a].name, from, to);
        printf(study->axes[a].steps == 1 ? "%zu step" : "%zu steps", study->axes[a].steps);
    }
    if (study->runs > 1)
        printf("%s %zu runs%s, seeds %" PRIu64 " to %" PRIu64, study->axis_count ? "," : ":", study->runs,
               study->axis_count ? " of each" : "", study->seed, study->seed + study->runs - 1);
    for (size_t s = 0; s < study->spread_count; s++)
        printf(", %s with a standard deviation of %g %%", study->spreads[s].name, 100 * study->spreads[s].share);
    printf("\n");
}

static const char *state_text(const StudyLaboratory *laboratory, SummaryState state) {
    switch (state) {
    case SUMMARY_REGULAR:
        return laboratory->regular;
    case SUMMARY_IRREGULAR:
        return laboratory->irregular;
    case SUMMARY_MIXED:
        return laboratory->mixed;
    case SUMMARY_UNDECIDED:
        return "cannot be told";
    case SUMMARY_NOTHING:
        break;
    }
    return "not run";
}

/* Prints a range: "not out up to 0.83 m", "out from 0.84 m on". */
static void print_range(const Study *study, const StudyLaboratory *laboratory, size_t axis, const SummaryRange *range) {
    size_t last = study->axes[axis].steps - 1;
    char from[WORD], to[WORD];
    study_number_step(study, axis, range->first, range->first == range->last || range->last == last, from);
    study_number_step(study, axis, range->last, true, to);
    printf("%s ", state_text(laboratory, range->state));
    if (range->first == 0 && range->last == last)
        printf("throughout");
    else if (range->first == 0 && range->last > 0)
        printf("up to %s", to);
    else if (range->last == last && range->first < last)
        printf("from %s on", from);
    else if (range->first == range->last)
        printf("at %s", from);
    else
        printf("from %s to %s", from, to);
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

static void print_ranges(const Study *study, const StudyLaboratory *laboratory, size_t pass, size_t axis) {
    size_t count;
    SummaryRange *ranges = summary_ranges(study, pass, axis, &count);
    if (count <= RANGES_MOST) {
        for (size_t r = 0; r < count; r++) {
            printf("%s", r ? ", " : "");
            print_range(study, laboratory, axis, &ranges[r]);
        }
    } else {
        printf("%s at %zu of %zu values", laboratory->regular, values_of(ranges, count, SUMMARY_REGULAR),
               study->axes[axis].steps);
        size_t undecided = values_of(ranges, count, SUMMARY_UNDECIDED);
        if (undecided)
            printf(" (at %zu it cannot be told)", undecided);
        printf(", the answer changes %zu times", count - 1);
        const char *before = "; the longest stretches: ";
        for (SummaryState state = SUMMARY_REGULAR; state <= SUMMARY_IRREGULAR; state++) {
            const SummaryRange *range = longest(ranges, count, state);
            if (!range)
                continue;
            printf("%s", before);
            print_range(study, laboratory, axis, range);
            before = ", ";
        }
    }
    memory_free(ranges);
}

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
    Course course = {.first = SIZE_MAX, .falls = true, .rises = true};
    double last = 0, least = HUGE_VAL, greatest = -HUGE_VAL;
    for (size_t i = 0; i < study_steps(study, 0); i++) {
        double mean = mean_measure(study, pass, i);
        if (isnan(mean))
            continue;
        bool begun = course.first < SIZE_MAX;
        course.falls &= !begun || mean <= last;
        course.rises &= !begun || mean >= last;
        course.first = begun ? course.first : i;
        course.least = mean < least ? i : course.least;
        course.greatest = mean > greatest ? i : course.greatest;
        course.last = i;
        last = mean;
        least = fmin(least, mean);
        greatest = fmax(greatest, mean);
    }
    return course;
}

/* Writes the mean measure at a step: "31.2 s". */
static void say_measure(const Study *study, size_t pass, size_t i, bool with_unit, char word[WORD]) {
    const char *unit = study_number_unit(&study->experiment->observables[study->experiment->measure]);
    study_number_observed(mean_measure(study, pass, i), word);
    if (with_unit && *unit)
        snprintf(word + strlen(word), WORD - strlen(word), " %.15s", unit);
}

/* Prints whether the measure falls, rises, or has a least and a greatest value in between. */
static void print_course(const Study *study, size_t pass) {
    Course course = follow_course(study, pass);
    if (course.first == SIZE_MAX)
        return;
    char first[WORD], last[WORD], value[WORD], at[WORD];
    say_measure(study, pass, course.first, false, first);
    say_measure(study, pass, course.last, true, last);
    printf("; the %s ", study->experiment->observables[study->experiment->measure].meaning);
    if (course.falls && course.rises) {
        printf("is %s", last);
        return;
    }
    printf("%s from %s to %s", course.falls ? "falls" : course.rises ? "rises" : "goes", first, last);
    for (int greatest = 0; greatest <= 1 && !course.falls && !course.rises; greatest++) {
        size_t i = greatest ? course.greatest : course.least;
        if (i == course.first || i == course.last)
            continue;
        say_measure(study, pass, i, true, value);
        study_number_step(study, 0, i, true, at);
        printf(", %s %s at %s", greatest ? "greatest" : "least", value, at);
    }
}

static void print_extreme(const Study *study, bool greatest) {
    size_t index = summary_extreme(study, greatest);
    if (index == SIZE_MAX)
        return;
    const Observable *measure = &study->experiment->observables[study->experiment->measure];
    const Trial *trial = &study->trials[index];
    char number[WORD];
    study_number_observed(trial->observed[study->experiment->measure], number);
    if (greatest)
        printf("; greatest, %s %s, at", number, study_number_unit(measure));
    else
        printf("the %s is least, %s %s, at", measure->meaning, number, study_number_unit(measure));
    for (size_t a = 0; a < study->axis_count; a++) {
        char value[WORD];
        study_number_value(study, a, trial->at[a], true, value);
        printf("%s %s %s", a ? "," : "", study->axes[a].name, value);
    }
    printf("%s", greatest ? "\n" : "");
}

/* Prints where passes end in different answers. */
static void print_differences(const Study *study) {
    size_t count = 0, first = 0;
    for (size_t i = study_steps(study, 0); i-- > 0;)
        if (summary_passes_differ(study, 0, i)) {
            count++;
            first = i;
        }
    char at[WORD];
    study_number_step(study, 0, first, true, at);
    if (count)
        printf("at %zu of %zu values, the first %s, the passes end in different answers: it depends on the past\n",
               count, study_steps(study, 0), at);
}

/* Tables --------------------------------------------------------------------------------------------------------- */

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

static void print_cell(const char *text, size_t width) {
    printf("  %*s", (int)width, text);
}

static size_t head_width(const char *name, const char *unit) {
    size_t width = strlen(name) + (*unit ? 1 + strlen(unit) : 0);
    return width < 8 ? 8 : width;
}

static void print_head(const char *name, const char *unit) {
    char head[2 * WORD];
    snprintf(head, sizeof head, "%.60s%s%.20s", name, *unit ? " " : "", unit);
    print_cell(head, head_width(name, unit));
}

/* True if a table of single runs shows the observable: if any run has it. */
static bool is_shown(const Study *study, const StudyLaboratory *laboratory, size_t observable) {
    const Experiment *experiment = study->experiment;
    if (observable == experiment->regular || strcmp(experiment->observables[observable].name, laboratory->hidden) == 0)
        return false;
    bool any = false;
    for (size_t t = 0; t < study->trial_count && !any; t++)
        any = !isnan(study->trials[t].observed[observable]);
    return any;
}

static void print_runs_row(const Study *study, const StudyLaboratory *laboratory, size_t pass, size_t i) {
    const Experiment *experiment = study->experiment;
    const Trial *trial = study_trial(study, pass, 0, 0, i);
    for (size_t o = 0; o < experiment->observable_count; o++) {
        const Observable *observable = &experiment->observables[o];
        char word[WORD];
        study_number_observed(trial->observed[o], word);
        if (is_shown(study, laboratory, o))
            print_cell(word, head_width(observable->name, study_number_unit(observable)));
    }
}

/* Prints the row of a point with many runs: the share of regular ones, and the distribution of the measure. */
static void print_point_row(const Study *study, size_t pass, size_t i) {
    MontecarloPoint point = montecarlo_point(study, pass, 0, i);
    const Distribution *d = &point.of[study->experiment->measure];
    const double numbers[] = {d->mean, d->deviation, d->low, d->median, d->high};
    char word[WORD] = "-";
    if (point.decided)
        snprintf(word, sizeof word, "%.0f %%", 100 * point.share);
    print_cell(word, 8);
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        study_number_observed(numbers[k], word);
        print_cell(word, 9);
    }
    montecarlo_clear(&point);
}

static void print_table_head(const Study *study, const StudyLaboratory *laboratory) {
    const Experiment *experiment = study->experiment;
    printf("\n");
    if (study->pass_count > 1)
        printf("  pass ");
    print_head(study->axes[0].name, study_number_axis_unit(study, 0));
    if (study->runs > 1) {
        static const char *const heads[] = {"mean", "deviation", "5 %", "50 %", "95 %"};
        print_cell(laboratory->regular, 8);
        for (size_t k = 0; k < sizeof heads / sizeof *heads; k++)
            print_cell(heads[k], 9);
        const Observable *measure = &experiment->observables[experiment->measure];
        printf("  of %s %s\n", measure->name, study_number_unit(measure));
        return;
    }
    print_cell("answer", 14);
    for (size_t o = 0; o < experiment->observable_count; o++)
        if (is_shown(study, laboratory, o))
            print_head(experiment->observables[o].name, study_number_unit(&experiment->observables[o]));
    printf("\n");
}

static void print_table(const Study *study, const StudyLaboratory *laboratory) {
    bool *chosen = memory_zeroed(study_steps(study, 0), sizeof *chosen);
    choose_rows(study, chosen);
    print_table_head(study, laboratory);
    for (size_t i = 0; i < study_steps(study, 0); i++)
        for (size_t pass = 0; pass < study->pass_count && chosen[i]; pass++) {
            char value[WORD];
            study_number_step(study, 0, i, false, value);
            if (study->pass_count > 1)
                printf("  %-5s", study_pass_name(study->passes[pass]));
            print_cell(value, head_width(study->axes[0].name, study_number_axis_unit(study, 0)));
            if (study->runs > 1) {
                print_point_row(study, pass, i);
            } else {
                print_cell(state_text(laboratory, summary_point(study, pass, 0, i)), 14);
                print_runs_row(study, laboratory, pass, i);
            }
            printf("\n");
        }
    memory_free(chosen);
}

static void print_map(const Study *study, const StudyLaboratory *laboratory, size_t pass) {
    static const char letters[] = {[SUMMARY_NOTHING] = ' ',
                                   [SUMMARY_REGULAR] = '#',
                                   [SUMMARY_IRREGULAR] = '.',
                                   [SUMMARY_MIXED] = '+',
                                   [SUMMARY_UNDECIDED] = '?'};
    size_t steps0 = study_steps(study, 0), steps1 = study_steps(study, 1);
    size_t columns = steps0 < MAP_COLUMNS ? steps0 : MAP_COLUMNS, rows = steps1 < MAP_ROWS ? steps1 : MAP_ROWS;
    SummaryCount count = summary_count(study);
    printf("\n# %s, . %s%s%s%s; to the right %s, upwards %s\n", laboratory->regular, laboratory->irregular,
           study->runs > 1 ? ", + sometimes" : "", count.undecided ? ", ? cannot be told" : "",
           count.faults || count.done < count.trials ? ", blank not run" : "", study->axes[0].name,
           study->axes[1].name);
    for (size_t r = rows; r-- > 0;) {
        size_t i1 = rows > 1 ? r * (steps1 - 1) / (rows - 1) : 0;
        char value[WORD];
        study_number_step(study, 1, i1, false, value);
        printf("%10s ", value);
        for (size_t c = 0; c < columns; c++)
            putchar(letters[summary_point(study, pass, i1, columns > 1 ? c * (steps0 - 1) / (columns - 1) : 0)]);
        printf("\n");
    }
    char from[WORD], to[WORD];
    study_number_step(study, 0, 0, false, from);
    study_number_step(study, 0, steps0 - 1, true, to);
    printf("%10s %s to %s\n", "", from, to);
}

static void print_distributions(const Study *study, const StudyLaboratory *laboratory) {
    static const char *const heads[] = {"mean", "deviation", "std error", "5 %", "50 %", "95 %"};
    const Experiment *experiment = study->experiment;
    MontecarloPoint point = montecarlo_point(study, 0, 0, 0);
    printf("\n%-20s", "");
    for (size_t k = 0; k < sizeof heads / sizeof *heads; k++)
        print_cell(heads[k], 10);
    printf("\n");
    for (size_t o = 0; o < point.observables; o++) {
        if (!is_shown(study, laboratory, o))
            continue;
        const Distribution *d = &point.of[o];
        const double numbers[] = {d->mean, d->deviation, d->error, d->low, d->median, d->high};
        char word[WORD];
        snprintf(word, sizeof word, "%.30s %.10s", experiment->observables[o].name,
                 study_number_unit(&experiment->observables[o]));
        printf("%-20s", word);
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
            study_number_observed(numbers[k], word);
            print_cell(word, 10);
        }
        printf("\n");
    }
    montecarlo_clear(&point);
}

/* The whole ------------------------------------------------------------------------------------------------------ */

static void print_faults(const Study *study, size_t faults) {
    for (size_t t = 0; t < study->trial_count && faults; t++)
        if (study->trials[t].fault) {
            printf(faults == 1 ? "%zu run could not be made: %s\n" : "%zu runs could not be made; the first: %s\n",
                   faults, study->trials[t].fault);
            return;
        }
}

static void print_share(const Study *study, const StudyLaboratory *laboratory) {
    MontecarloPoint point = montecarlo_point(study, 0, 0, 0);
    if (point.decided)
        printf("%s in %zu of %zu runs: %.1f %%, with 95 %% confidence from %.1f to %.1f %%\n", laboratory->regular,
               point.regular, point.decided, 100 * point.share, 100 * point.share_low, 100 * point.share_high);
    if (point.done > 1 && point.of[study->experiment->measure].deviation == 0)
        printf("all runs are alike, nothing in them is left to chance: --spread NAME=SHARE would give a tolerance\n");
    montecarlo_clear(&point);
}

static void print_count(const StudyLaboratory *laboratory, const SummaryCount *count) {
    printf("%s in %zu of %zu runs", laboratory->regular, count->regular, count->done - count->faults);
    if (count->undecided)
        printf(", in %zu it cannot be told", count->undecided);
    printf("\n");
}

void study_text_print(const Study *study, const StudyLaboratory *laboratory, const char *file) {
    SummaryCount count = summary_count(study);
    print_title(study, file);
    if (study->axis_count == 0)
        print_share(study, laboratory);
    if (study->axis_count == 2)
        print_count(laboratory, &count);
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t a = 0; a < study->axis_count; a++) {
            if (study->pass_count > 1)
                printf("%s: ", study_pass_name(study->passes[pass]));
            if (study->axis_count == 2)
                printf("along %s: ", study->axes[a].name);
            print_ranges(study, laboratory, pass, a);
            if (study->axis_count == 1)
                print_course(study, pass);
            printf("\n");
        }
    if (study->axis_count == 1)
        print_differences(study);
    if (study->axis_count == 2) {
        print_extreme(study, false);
        print_extreme(study, true);
        for (size_t pass = 0; pass < study->pass_count; pass++)
            print_map(study, laboratory, pass);
    } else if (study->axis_count == 1) {
        print_table(study, laboratory);
    } else {
        print_distributions(study, laboratory);
    }
    print_faults(study, count.faults);
}
