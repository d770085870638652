#include "visual/study/fit_plots.h"

#include <math.h>

#include "base/real.h"
#include "base/text.h"

#define SIZE 9.0 /* design points, across a symbol */

#define BEYOND 1.15 /* 1, share of the frame that the farthest value leaves */

#define LIMIT 2.0 /* standard deviations, of the lines */

static double residual(const FitRow *row, double value) {
    double off = row->relative ? real_log(value / row->observed) : value - row->observed;
    return off / row->deviation;
}

/* Adds the residuals of all rows, before the fit or after it. */
static void add_series(Plot *plot, const Fit *fit, bool after, Arena *arena) {
    double *x = arena_allocate(arena, fit->row_count * sizeof *x);
    double *y = arena_allocate(arena, fit->row_count * sizeof *y);
    for (size_t r = 0; r < fit->row_count; r++) {
        const FitRow *row = &fit->rows[r];
        x[r] = (double)(r + 1);
        y[r] = after ? row->residual : residual(row, row->before);
    }
    plot->series[plot->series_count++] = (PlotSeries){.name = after ? "fitted" : "before",
                                                      .x = x,
                                                      .y = y,
                                                      .count = fit->row_count,
                                                      .role = after ? ROLE_LOCUS : ROLE_LOCUS_SECOND,
                                                      .symbol = after ? SYMBOL_DISC : SYMBOL_BOX,
                                                      .size = SIZE,
                                                      .open = !after};
}

void fit_plots_residuals(Plot *plot, const Fit *fit, Arena *arena) {
    *plot = (Plot){.title = "Residuals: simulated minus observed",
                   .x = {.title = "measured value, in the order of the file"},
                   .y = {.title = "residual, standard deviations"}};
    double most = LIMIT; /* the lines lie within the frame, not on it */
    for (size_t r = 0; r < fit->row_count; r++) {
        double before = residual(&fit->rows[r], fit->rows[r].before);
        most = fmax(most, fmax(isfinite(before) ? fabs(before) : 0,
                               isfinite(fit->rows[r].residual) ? fabs(fit->rows[r].residual) : 0));
    }
    plot->y.high = BEYOND * most;
    plot->y.low = -plot->y.high;
    plot->x.low = 0;
    plot->x.high = (double)fit->row_count + 1;
    plot->series = arena_allocate(arena, 2 * sizeof *plot->series);
    plot->guides = arena_allocate(arena, 3 * sizeof *plot->guides);
    for (int k = -1; k <= 1; k++)
        plot->guides[plot->guide_count++] =
            (PlotGuide){.at = k * LIMIT, .role = ROLE_DIM_TEXT, .style = k ? LINE_DASHED : LINE_SOLID};
    add_series(plot, fit, false, arena);
    add_series(plot, fit, true, arena);
    plot->note = text_in_arena(arena, "dashed: 2 standard deviations; sum of squares %.1f before, %.1f fitted",
                               fit->sum_before, fit->sum);
}
