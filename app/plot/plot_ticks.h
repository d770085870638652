/* Round numbers along an axis, and their labels: multiples of 1, 2 or 5 times a power of ten; along a logarithmic
 * axis, powers of ten, and 2 and 5 times them where there is room. An axis has at least 2 ticks: where these steps
 * have fewer, linear axes also take 4 times a power of ten, and logarithmic ones every second tick or equal steps. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct PlotTicks {
    double low, high; /* of the axis, low < high */
    double first;     /* of the ticks, in steps from 0 */
    int count;
    int multiple, exponent; /* a step is multiple x 10^exponent */
    int power;  /* labels count in 10^power of the axis' unit: a multiple of 3 that keeps them short; independent of the
                   tick count */
    int digits; /* of labels, behind the point */
    int stride; /* of these steps from a tick to the next */
    bool logarithmic; /* a step is then 10^multiple; multiple 0: 1, 2, 5, 10 and so on */
    bool equal;       /* though the axis is logarithmic, a step is multiple x 10^exponent */
    bool raised;      /* labels are powers of ten with a raised exponent */
} PlotTicks;

enum {
    PLOT_TICKS_LABEL = 48,  /* room for a label */
    PLOT_TICKS_TITLE = 192, /* room for an axis' title */
};

/* Makes at least 2 and at most `most` ticks, or 3 where none of the steps has 2, over an axis from low to high, with
 * the smallest step possible. `widened` moves the ends out to whole halves of a step. An invalid range is replaced:
 * equal ends reach from 0 to their value, ends that are not numbers from 0 to 1; a span below a millionth of the values
 * is widened to that. */
PlotTicks plot_ticks_make(double low, double high, int most, bool widened);

/* Does the same for a logarithmic axis: `widened` moves the ends out to ticks. An invalid or nonpositive range is
 * replaced. */
PlotTicks plot_ticks_make_logarithmic(double low, double high, int most, bool widened);

/* Returns the share of the axis below a value: 0 at the low end, 1 at the high end. */
double plot_ticks_part(const PlotTicks *ticks, double value);

/* Returns the value of tick `index`, exactly the number on its label. */
double plot_ticks_at(const PlotTicks *ticks, int index);

/* Prints "0", "-1.5" with a true minus, "20 000" with a thin space. */
void plot_ticks_label(const PlotTicks *ticks, int index, char label[PLOT_TICKS_LABEL]);

/* Prints "force, 10^6 N" with a raised 6; "time, s"; "ratio" where the unit is NULL, "" or "1". */
void plot_ticks_title(const PlotTicks *ticks, const char *title, const char *unit, char text[PLOT_TICKS_TITLE]);
