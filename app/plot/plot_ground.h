/* The part of a plot that stays fixed while its series are drawn: paper, faint lines, guides and axes below the
 * series, texts above them. */
#pragma once

#include "plot/plot_layout.h"

struct _cairo; /* cairo's own name of cairo_t */

void plot_ground_paint(struct _cairo *cairo, const PlotLayout *layout, const Plot *plot, Theme theme);
void plot_ground_paint_text(struct _cairo *cairo, const PlotLayout *layout, Theme theme);
