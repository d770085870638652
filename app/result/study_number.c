#include "result/study_number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/real.h"

static bool is_multiple(double value, int decimals) {
    double scaled = value * real_power_of_ten(decimals);
    return fabs(scaled - round(scaled)) < 1e-6;
}

/* The unit in which an axis is shown: mm and ms for small lengths and times, rpm for the speed of a shaft. */
typedef struct Shown {
    const char *unit; /* "" for pure numbers */
    double factor;    /* 1, by which values are multiplied */
} Shown;

static Shown shown_axis(const Study *study, size_t a) {
    const StudyAxis *axis = &study->axes[a];
    const char *unit = study->experiment->parameter(study->experiment->given, axis->name)->unit;
    if (experiment_turns(study->experiment, axis->name))
        return (Shown){"rpm", EXPERIMENT_RPM};
    bool small = fmax(fabs(axis->from), fabs(axis->to)) < 0.01;
    if (small && strcmp(unit, "m") == 0)
        return (Shown){"mm", 1000};
    if (small && strcmp(unit, "s") == 0)
        return (Shown){"ms", 1000};
    return (Shown){strcmp(unit, "1") == 0 ? "" : unit, 1};
}

const char *study_number_axis_unit(const Study *study, size_t axis) {
    return shown_axis(study, axis).unit;
}

/* As many digits as tell values of at most `most` apart that lie a step apart, 3 to 9. */
static int digits_that_tell(double most, double step) {
    int digits = 3;
    while (digits < 9 && real_power_of_ten(digits - 2) * step < most)
        digits++;
    return digits;
}

void study_number_value(const Study *study, size_t a, double value, bool with_unit, char word[STUDY_NUMBER]) {
    const StudyAxis *axis = &study->axes[a];
    Shown shown = shown_axis(study, a);
    double from = axis->from * shown.factor, to = axis->to * shown.factor, most = fmax(fabs(from), fabs(to));
    double step = axis->steps > 1 ? fabs(to - from) / (double)(axis->steps - 1) : fabs(from);
    int decimals = 0;
    while (decimals < 6 && (!is_multiple(from, decimals) || !is_multiple(step, decimals)))
        decimals++;
    int length = most < 1e-3 || most >= 1e7 || decimals == 6
                     ? snprintf(word, STUDY_NUMBER, "%.*g", digits_that_tell(most, step), value * shown.factor)
                     : snprintf(word, STUDY_NUMBER, "%.*f", decimals, value * shown.factor);
    if (with_unit && *shown.unit)
        snprintf(word + length, STUDY_NUMBER - (size_t)length, " %.15s", shown.unit);
}

void study_number_step(const Study *study, size_t axis, size_t i, bool with_unit, char word[STUDY_NUMBER]) {
    study_number_value(study, axis, study_value(&study->axes[axis], i), with_unit, word);
}

void study_number_observed(double number, char word[STUDY_NUMBER]) {
    if (isnan(number))
        snprintf(word, STUDY_NUMBER, "-");
    else
        snprintf(word, STUDY_NUMBER, fabs(number) >= 1000 && fabs(number) < 1e7 ? "%.0f" : "%.4g", number);
}

const char *study_number_unit(const Observable *observable) {
    return strcmp(observable->unit, "1") == 0 ? "" : observable->unit;
}
