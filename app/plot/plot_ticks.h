/* Round numbers along an axis, and their labels: multiples of 1, 2 or 5 times a power of ten; along a logarithmic axis,
 * powers of ten, and 2 and 5 times them where there is room. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct PlotTicks {
    double low, high; /* of the axis, low < high */
    double first;     /* of the ticks, in steps from nought */
    int count;
    int multiple, exponent; /* a step is multiple x 10^exponent */
    int power;              /* labels count 10^power of the axis' unit: a multiple of 3 that keeps them short; the same
                             * for any number of ticks */
    int digits;             /* of labels, behind the point */
    bool logarithmic;       /* a step is then 10^multiple; multiple 0: 1, 2, 5, 10 and so on */
    bool raised;            /* labels are powers of ten with a raised exponent */
} PlotTicks;

enum {
    PLOT_TICKS_LABEL = 48,  /* room for a label */
    PLOT_TICKS_TITLE = 192, /* room for an axis' title */
};

/* At most `most` ticks, at least 2, over an axis from low to high: the smallest step that does. `widened` moves the
 * ends out to whole halves of a step. What is no range becomes one: equal ends reach from nought to their value, ends
 * that are no numbers from 0 to 1; a span below a millionth of the values is widened to that. */
PlotTicks plot_ticks_make(double low, double high, int most, bool widened);

/* The same of a logarithmic axis from low to high: `widened` moves the ends out to ticks. What is no range above nought
 * becomes one. */
PlotTicks plot_ticks_make_logarithmic(double low, double high, int most, bool widened);

/* How far along the axis a value is, from 0 at its low end to 1. */
double plot_ticks_part(const PlotTicks *ticks, double value);

/* The value of tick `index`; exactly the number that its label says. */
double plot_ticks_at(const PlotTicks *ticks, int index);

/* "0", "-1.5" with a true minus, "20 000" with a thin space. */
void plot_ticks_label(const PlotTicks *ticks, int index, char label[PLOT_TICKS_LABEL]);

/* "force, 10^6 N" with a raised 6; "time, s"; "ratio" where the unit is NULL, "" or "1". */
void plot_ticks_title(const PlotTicks *ticks, const char *title, const char *unit, char text[PLOT_TICKS_TITLE]);
