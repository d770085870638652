/* Beside a raster: which colour is which class, or how much of the quantity. */
#pragma once

#include "plot/plot_layout.h"

/* Finds the key's place beside the frame, which reaches to the page's end still; returns how much the frame must leave
 * to it. At most so many ticks. */
double plot_key_place(PlotLayout *layout, const Plot *plot, int most);

/* Adds its words. */
void plot_key_add(PlotLayout *layout, const Plot *plot);

/* Where the colour of a class is shown. */
Box plot_key_class(const PlotLayout *layout, const Plot *plot, size_t index);
