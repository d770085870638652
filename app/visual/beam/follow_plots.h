/* Followed orbits as a plot: the largest force over the number that changes, full lines where the orbit is stable and
 * dashed ones where it is not, and a sign at each located point. */
#pragma once

#include "base/memory.h"
#include "cycle/follow_curve.h"
#include "plot/plot.h"

enum { FOLLOW_PLOTS_BRANCHES = 4 /* of one plot, at most */ };

typedef struct FollowPlot {
    Plot plot;
    Arena arena; /* of its numbers */
} FollowPlot;

/* Peaks of runs from rest, for comparison: (count) values and forces in N. */
typedef struct FollowDots {
    const double *value, *peak;
    size_t count;
} FollowDots;

/* `factor` times a value is in the axis' unit. follow_plots_free releases the plot; the dots must outlive it. */
FollowPlot follow_plots_make(const FollowBranch *branches, size_t count, PlotAxis axis, double factor,
                             const FollowDots *dots);

/* Adds curves over two numbers to a plot, which must have room for FOLLOW_PLOTS_CURVES more series: full lines are
 * folds, and in another colour Neimark-Sacker points; dashed ones flips, dash-dotted ones pitchforks, dotted ones where
 * the motion without contact ends. */
enum { FOLLOW_PLOTS_CURVES = 24 };
void follow_plots_add_curves(Plot *plot, const FollowCurve *curves, size_t count, double x_factor, double y_factor,
                             Arena *arena);

/* Makes a plot of curves alone. */
FollowPlot follow_plots_make_curves(const FollowCurve *curves, size_t count, PlotAxis x, double x_factor, PlotAxis y,
                                    double y_factor);
void follow_plots_free(FollowPlot *plot);
