/* Names on a plot, beside what they name, where they hide nothing. */
#pragma once

#include "plot/plot_layout.h"

/* Adds the guides' names, each at its line, wherever that hides least. */
void plot_names_guides(PlotLayout *layout, const Plot *plot);

/* Adds the marks of a raster's classes, each in the largest square of the class. */
void plot_names_classes(PlotLayout *layout, const Plot *plot);

/* Adds the series' names beside their lines. False: there is no room for all of them, and none is added. */
bool plot_names_series(PlotLayout *layout, const Plot *plot);
