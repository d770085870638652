#include "plot/plot_ticks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vec2.h"

#define LARGEST 1e100     /* powers of ten beyond it, or nearer to 0 than its inverse, would overflow */
#define FINEST 1e-6       /* of the values: a smaller span is rounding */
#define NEARLY 1e-9       /* of a step: an end at most this far beyond a tick is on the tick */
#define PLAIN_LARGEST 1e5 /* the largest and smallest order that labels show without a power of ten: */
#define PLAIN_LEAST 1e-3  /* five digits before the point or four behind it */
#define LEAST 2           /* ticks of an axis */
#define LONGEST_COUNT 4   /* digits that are legible without a gap */

#define THIN_SPACE "\u2009"
#define MINUS "\u2212"

/* Returns multiple x 10^exponent with the least rounding. */
static double decimal(double multiple, int exponent) {
    return exponent < 0 ? multiple / pow(10, -exponent) : multiple * pow(10, exponent);
}

static void make_range(double *low, double *high) {
    if (isnan(*low) || isnan(*high) || *low > *high) {
        *low = 0;
        *high = 1;
    }
    *low = real_clamp(*low, -LARGEST, LARGEST);
    *high = real_clamp(*high, -LARGEST, LARGEST);
    double largest = fmax(fabs(*low), fabs(*high));
    if (largest < 1 / LARGEST) {
        *low = 0;
        *high = 1;
    } else if (*low == *high) {
        *low = fmin(*low, 0);
        *high = fmax(*high, 0);
    } else if (*high - *low < FINEST * largest) {
        double middle = (*low + *high) / 2;
        *low = middle - FINEST * largest / 2;
        *high = middle + FINEST * largest / 2;
    }
}

/* Returns the ticks of a range with a step of multiple x 10^exponent. */
static PlotTicks with_step(double low, double high, int multiple, int exponent, bool widened) {
    PlotTicks ticks = {.low = low, .high = high, .multiple = multiple, .exponent = exponent, .stride = 1};
    double step = decimal(multiple, exponent);
    if (widened) {
        ticks.low = floor(2 * low / step + NEARLY) / 2 * step;
        ticks.high = ceil(2 * high / step - NEARLY) / 2 * step;
    }
    ticks.first = ceil(ticks.low / step - NEARLY);
    ticks.count = (int)(floor(ticks.high / step + NEARLY) - ticks.first) + 1;
    return ticks;
}

/* Returns the multiple of 3 below the order of a number that has too many digits before or behind the point. */
static int label_power(double largest) {
    if (largest >= PLAIN_LEAST && largest < PLAIN_LARGEST)
        return 0;
    return 3 * (int)floor((log10(largest) + NEARLY) / 3);
}

/* Returns the finest of these steps, `count` multiples in each decade, with at most `most` ticks. */
static PlotTicks with_multiples(double low, double high, const int *multiples, int count, int most, bool widened) {
    PlotTicks ticks;
    int step = count * (int)floor(log10((high - low) / most));
    do {
        int decade = (int)floor((double)step / count);
        ticks = with_step(low, high, multiples[step - count * decade], decade, widened);
        step++;
    } while (ticks.count > most);
    return ticks;
}

PlotTicks plot_ticks_make(double low, double high, int most, bool widened) {
    static const int usual[] = {1, 2, 5}, closer[] = {1, 2, 4, 5};
    make_range(&low, &high);
    PlotTicks ticks = with_multiples(low, high, usual, 3, most > LEAST ? most : LEAST, widened);
    if (ticks.count < LEAST) /* any 4 ticks of one of these steps hold 2 of the next one: some step has 2 or 3 */
        ticks = with_multiples(low, high, closer, 4, LEAST + 1, widened);
    if (most < LEAST && ticks.count > LEAST) { /* no room for the middle one of three */
        ticks.stride = 2;
        ticks.count = LEAST;
    }
    ticks.power = label_power(fmax(fabs(low), fabs(high)));
    ticks.digits = ticks.power > ticks.exponent ? ticks.power - ticks.exponent : 0;
    return ticks;
}

/* Returns a tick of a logarithmic axis, counted from the tick at 1. */
static double logarithmic_at(int multiple, double tick) {
    static const double mantissas[] = {1, 2, 5};
    if (multiple)
        return decimal(1, (int)tick * multiple);
    double decade = floor(tick / 3);
    return decimal(mantissas[(int)(tick - 3 * decade)], (int)decade);
}

/* Returns ticks in steps of `multiple` decades. */
static PlotTicks with_decades(double low, double high, int multiple, bool widened) {
    PlotTicks ticks = {.low = low, .high = high, .multiple = multiple, .stride = 1, .logarithmic = true};
    double slack = 1 + NEARLY, per_decade = multiple ? 1.0 / multiple : 3;
    double first = floor(log10(low) * per_decade) - 1, last = ceil(log10(high) * per_decade) + 1;
    while (logarithmic_at(multiple, first + 1) <= low * slack)
        first++;
    while (logarithmic_at(multiple, last - 1) * slack >= high)
        last--;
    if (widened) {
        ticks.low = logarithmic_at(multiple, first);
        ticks.high = logarithmic_at(multiple, last);
    } else {
        first += logarithmic_at(multiple, first) * slack < low;
        last -= logarithmic_at(multiple, last) > high * slack;
    }
    ticks.first = first;
    ticks.count = (int)fmax(0, last - first + 1);
    return ticks;
}

/* Returns the finest steps with at most `most` ticks, or, if there are none, steps beyond the range. */
static PlotTicks with_few_decades(double low, double high, int most, bool widened) {
    PlotTicks ticks;
    int decades = 0;
    do
        ticks = with_decades(low, high, decades++, widened);
    while (ticks.count > most && decades < log10(high / low) + 2);
    return ticks;
}

PlotTicks plot_ticks_make_logarithmic(double low, double high, int most, bool widened) {
    if (!(low > 0 && high >= low && high < HUGE_VAL)) {
        low = 0.1;
        high = 1;
    }
    low = real_clamp(low, 1 / LARGEST, LARGEST);
    high = real_clamp(high, low * (1 + FINEST), LARGEST * 10);
    int wanted = most > LEAST ? most : LEAST;
    PlotTicks ticks = with_few_decades(low, high, wanted, widened);
    if (ticks.count > wanted || ticks.count < LEAST) /* around 1, even the widest steps have 3 */
        ticks = with_few_decades(low, high, LEAST + 1, widened);
    if (ticks.count < LEAST && ticks.multiple) { /* at most 5 ticks of 1, 2, 5 hold fewer than 2 powers of ten */
        ticks = with_decades(low, high, 0, widened);
        ticks.stride = 2;
        ticks.count = (ticks.count + 1) / 2;
    }
    if (ticks.count < LEAST) {
        ticks = plot_ticks_make(low, high, most, false);
        ticks.logarithmic = ticks.equal = true;
    }
    ticks.raised = !ticks.equal && ticks.multiple && (ticks.high >= PLAIN_LARGEST || ticks.low < PLAIN_LEAST);
    return ticks;
}

double plot_ticks_part(const PlotTicks *ticks, double value) {
    if (ticks->logarithmic)
        return value > 0 ? log(value / ticks->low) / log(ticks->high / ticks->low) : -HUGE_VAL;
    return (value - ticks->low) / (ticks->high - ticks->low);
}

double plot_ticks_at(const PlotTicks *ticks, int index) {
    if (ticks->logarithmic && !ticks->equal)
        return logarithmic_at(ticks->multiple, ticks->first + index * ticks->stride);
    return decimal((ticks->first + index * ticks->stride) * ticks->multiple, ticks->exponent);
}

/* Prints "10" with the power raised behind it. */
static void raised_power(int power, char text[PLOT_TICKS_LABEL]) {
    static const char *const raised[] = {"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                         "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    char digits[16];
    snprintf(digits, sizeof digits, "%d", abs(power));
    strcpy(text, power < 0 ? "10\u207B" : "10");
    for (const char *digit = digits; *digit; digit++)
        strcat(text, raised[*digit - '0']);
}

static void logarithmic_label(const PlotTicks *ticks, int index, char label[PLOT_TICKS_LABEL]) {
    if (ticks->raised)
        raised_power((int)(ticks->first + index * ticks->stride) * ticks->multiple, label);
    else
        snprintf(label, PLOT_TICKS_LABEL, "%.9g", plot_ticks_at(ticks, index));
}

void plot_ticks_label(const PlotTicks *ticks, int index, char label[PLOT_TICKS_LABEL]) {
    if (ticks->logarithmic && !ticks->equal) {
        logarithmic_label(ticks, index, label);
        return;
    }
    char digits[PLOT_TICKS_LABEL / 2];
    double steps = ticks->first + index * ticks->stride;
    const char *sign = steps < 0 ? MINUS : "";
    int decimals = steps == 0 ? 0 : ticks->digits;
    double value = decimal(fabs(steps) * ticks->multiple, ticks->exponent - ticks->power);
    int length = snprintf(digits, sizeof digits, "%.*f", decimals, value);
    int whole = length - (decimals ? decimals + 1 : 0);
    if (whole > LONGEST_COUNT)
        snprintf(label, PLOT_TICKS_LABEL, "%s%.*s" THIN_SPACE "%s", sign, whole - 3, digits, digits + whole - 3);
    else
        snprintf(label, PLOT_TICKS_LABEL, "%s%s", sign, digits);
}

void plot_ticks_title(const PlotTicks *ticks, const char *title, const char *unit, char text[PLOT_TICKS_TITLE]) {
    char power[PLOT_TICKS_LABEL] = "";
    if (ticks->power)
        raised_power(ticks->power, power);
    if (!unit || strcmp(unit, "1") == 0)
        unit = "";
    snprintf(text, PLOT_TICKS_TITLE, "%s%s%s%s%s", title ? title : "", title && (*power || *unit) ? ", " : "", power,
             *power && *unit ? " " : "", unit);
}
