#include "command/study_words.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "command/study_table.h"
#include "study/montecarlo.h"
#include "study/summary.h"

enum { WORD = STUDY_WORDS_WORD, RANGES_MOST = 6 /* told one by one */ };

/* Numbers -------------------------------------------------------------------------------------------------------- */

static bool is_multiple(double value, int decimals) {
    double scaled = value * pow(10, decimals);
    return fabs(scaled - round(scaled)) < 1e-6;
}

/* How an axis is shown: small lengths and times in mm and ms. */
typedef struct Shown {
    const char *unit; /* "" for pure numbers */
    double factor;    /* 1, of the values */
} Shown;

static Shown shown_axis(const Study *study, size_t a) {
    const StudyAxis *axis = &study->axes[a];
    const char *unit = study->experiment->parameter(study->experiment->given, axis->name)->unit;
    bool small = fmax(fabs(axis->from), fabs(axis->to)) < 0.01;
    if (small && strcmp(unit, "m") == 0)
        return (Shown){"mm", 1000};
    if (small && strcmp(unit, "s") == 0)
        return (Shown){"ms", 1000};
    return (Shown){strcmp(unit, "1") == 0 ? "" : unit, 1};
}

const char *study_words_axis_unit(const Study *study, size_t axis) {
    return shown_axis(study, axis).unit;
}

/* A value of an axis, with as many digits as tell it from its neighbours. */
static void say_value(const Study *study, size_t a, double value, bool with_unit, char word[WORD]) {
    const StudyAxis *axis = &study->axes[a];
    Shown shown = shown_axis(study, a);
    double from = axis->from * shown.factor, to = axis->to * shown.factor, most = fmax(fabs(from), fabs(to));
    double step = axis->steps > 1 ? fabs(to - from) / (double)(axis->steps - 1) : fabs(from);
    int decimals = 0;
    while (decimals < 6 && (!is_multiple(from, decimals) || !is_multiple(step, decimals)))
        decimals++;
    int length =
        most < 1e-3 || most >= 1e7 || decimals == 6
            ? snprintf(word, WORD, "%.*g", (int)fmax(3, fmin(9, ceil(log10(most / step)) + 2)), value * shown.factor)
            : snprintf(word, WORD, "%.*f", decimals, value * shown.factor);
    if (with_unit && *shown.unit)
        snprintf(word + length, WORD - (size_t)length, " %.15s", shown.unit);
}

void study_words_step(const Study *study, size_t axis, size_t i, bool with_unit, char word[WORD]) {
    say_value(study, axis, study_value(&study->axes[axis], i), with_unit, word);
}

void study_words_number(double number, char word[WORD]) {
    if (isnan(number))
        snprintf(word, WORD, "-");
    else
        snprintf(word, WORD, fabs(number) >= 1000 && fabs(number) < 1e7 ? "%.0f" : "%.4g", number);
}

const char *study_words_unit(const Observable *observable) {
    return strcmp(observable->unit, "1") == 0 ? "" : observable->unit;
}

/* Sentences ------------------------------------------------------------------------------------------------------ */

static void print_title(const Study *study, const char *file) {
    printf("%s", file);
    for (size_t a = 0; a < study->axis_count; a++) {
        char from[WORD], to[WORD];
        study_words_step(study, a, 0, false, from);
        study_words_step(study, a, study->axes[a].steps - 1, true, to);
        printf("%s %s from %s to %s in %zu step%s", a ? "," : ":", study->axes[a].name, from, to, study->axes[a].steps,
               study->axes[a].steps == 1 ? "" : "s");
    }
    if (study->runs > 1)
        printf("%s %zu runs%s, seeds %" PRIu64 " to %" PRIu64, study->axis_count ? "," : ":", study->runs,
               study->axis_count ? " of each" : "", study->seed, study->seed + study->runs - 1);
    for (size_t s = 0; s < study->spread_count; s++)
        printf(", %s with a standard deviation of %g %%", study->spreads[s].name, 100 * study->spreads[s].share);
    printf("\n");
}

const char *study_words_state(const StudyLaboratory *laboratory, SummaryState state) {
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

/* "not out up to 0.83 m", "out from 0.84 m on" */
static void print_range(const Study *study, const StudyLaboratory *laboratory, size_t axis, const SummaryRange *range) {
    size_t last = study->axes[axis].steps - 1;
    char from[WORD], to[WORD];
    study_words_step(study, axis, range->first, range->first == range->last || range->last == last, from);
    study_words_step(study, axis, range->last, true, to);
    printf("%s ", study_words_state(laboratory, range->state));
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

/* The longest range of a state; NULL: there is none. */
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

/* How the measure goes along the only axis. */
typedef struct Course {
    size_t first, last, least, greatest; /* steps; SIZE_MAX: the measure is nowhere */
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

/* "31.2 s" of the measure at a step */
static void say_measure(const Study *study, size_t pass, size_t i, bool with_unit, char word[WORD]) {
    const char *unit = study_words_unit(&study->experiment->observables[study->experiment->measure]);
    study_words_number(mean_measure(study, pass, i), word);
    if (with_unit && *unit)
        snprintf(word + strlen(word), WORD - strlen(word), " %.15s", unit);
}

/* It falls, rises, or goes over a least and a greatest. */
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
        study_words_step(study, 0, i, true, at);
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
    study_words_number(trial->observed[study->experiment->measure], number);
    if (greatest)
        printf("; greatest, %s %s, at", number, study_words_unit(measure));
    else
        printf("the %s is least, %s %s, at", measure->meaning, number, study_words_unit(measure));
    for (size_t a = 0; a < study->axis_count; a++) {
        char value[WORD];
        say_value(study, a, trial->at[a], true, value);
        printf("%s %s %s", a ? "," : "", study->axes[a].name, value);
    }
    printf("%s", greatest ? "\n" : "");
}

/* Passes that end in different answers. */
static void print_differences(const Study *study) {
    size_t count = 0, first = 0;
    for (size_t i = study_steps(study, 0); i-- > 0;)
        if (summary_passes_differ(study, 0, i)) {
            count++;
            first = i;
        }
    char at[WORD];
    study_words_step(study, 0, first, true, at);
    if (count)
        printf("at %zu of %zu values, the first %s, the passes end in different answers: it depends on the past\n",
               count, study_steps(study, 0), at);
}

/* The whole ------------------------------------------------------------------------------------------------------ */

static void print_faults(const Study *study, size_t faults) {
    for (size_t t = 0; t < study->trial_count && faults; t++)
        if (study->trials[t].fault) {
            printf("%zu run%s could not be made; the first: %s\n", faults, faults == 1 ? "" : "s",
                   study->trials[t].fault);
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

void study_words_print(const Study *study, const StudyLaboratory *laboratory, const char *file) {
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
            study_table_map(study, laboratory, pass);
    } else if (study->axis_count == 1) {
        study_table_print(study, laboratory);
    } else {
        study_table_distributions(study, laboratory);
    }
    print_faults(study, count.faults);
}
