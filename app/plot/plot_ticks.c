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
    PlotTicks ticks = {.low = low, .high = high, .multiple = multiple, .exponent = exponent};
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

PlotTicks plot_ticks_make(double low, double high, int most, bool widened) {
    static const int multiples[] = {1, 2, 5};
    make_range(&low, &high);
    int first = 3 * (int)floor(log10((high - low) / most));
    PlotTicks ticks;
    int step = first;
    do {
        ticks = with_step(low, high, multiples[step - 3 * (int)floor(step / 3.0)], (int)floor(step / 3.0), widened);
        step++;
    } while (ticks.count > (most > 2 ? most : 2));
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
    PlotTicks ticks = {.low = low, .high = high, .multiple = multiple, .logarithmic = true};
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

PlotTicks plot_ticks_make_logarithmic(double low, double high, int most, bool widened) {
    if (!(low > 0 && high >= low && high < HUGE_VAL)) {
        low = 0.1;
        high = 1;
    }
    low = real_clamp(low, 1 / LARGEST, LARGEST);
    high = real_clamp(high, low * (1 + FINEST), LARGEST * 10);
    PlotTicks ticks;
    int decades = 0;
    do
        ticks = with_decades(low, high, decades++, widened);
    while (ticks.count > (most > 2 ? most : 2));
    ticks.raised = ticks.multiple && (ticks.high >= PLAIN_LARGEST || ticks.low < PLAIN_LEAST);
    return ticks;
}

double plot_ticks_part(const PlotTicks *ticks, double value) {
    if (ticks->logarithmic)
        return value > 0 ? log(value / ticks->low) / log(ticks->high / ticks->low) : -HUGE_VAL;
    return (value - ticks->low) / (ticks->high - ticks->low);
}

double plot_ticks_at(const PlotTicks *ticks, int index) {
    if (ticks->logarithmic)
        return logarithmic_at(ticks->multiple, ticks->first + index);
    return decimal((ticks->first + index) * ticks->multiple, ticks->exponent);
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
        raised_power((int)(ticks->first + index) * ticks->multiple, label);
    else
        snprintf(label, PLOT_TICKS_LABEL, "%.9g", plot_ticks_at(ticks, index));
}

void plot_ticks_label(const PlotTicks *ticks, int index, char label[PLOT_TICKS_LABEL]) {
    if (ticks->logarithmic) {
        logarithmic_label(ticks, index, label);
        return;
    }
    char digits[PLOT_TICKS_LABEL / 2];
    double steps = ticks->first + index;
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
