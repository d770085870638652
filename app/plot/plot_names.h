/* Names on a plot, next to their objects, where they hide nothing. */
#pragma once

#include "plot/plot_layout.h"

/* Adds the names of the guides, each at its line, where it hides least; not of those that are listed above the plot. */
void plot_names_guides(PlotLayout *layout, const Plot *plot, bool listed);

/* Adds the marks of a raster's classes, each in the largest square of the class. */
void plot_names_classes(PlotLayout *layout, const Plot *plot);

/* Adds the names of the series next to their lines; false if there is not room for all of them, and then none is
 * added. */
bool plot_names_series(PlotLayout *layout, const Plot *plot);
