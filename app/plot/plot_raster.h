/* Paints the cells of a raster, and its key, in colours and patterns. */
#pragma once

#include "plot/plot_layout.h"

struct _cairo; /* cairo's own name of cairo_t */

void plot_raster_paint(struct _cairo *cairo, const PlotLayout *layout, const Plot *plot, Theme theme);
