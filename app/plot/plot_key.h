/* The key of a raster: the colour of each class, or the colours of the quantity. */
#pragma once

#include "plot/plot_layout.h"

/* Finds the place of the key next to the frame, which still reaches to the end of the page; returns the width that the
 * frame must leave to the key. At most `most` ticks. */
double plot_key_place(PlotLayout *layout, const Plot *plot, int most);

/* Adds the texts of the key. */
void plot_key_add(PlotLayout *layout, const Plot *plot);

/* Returns the box that shows the colour of a class. */
Box plot_key_class(const PlotLayout *layout, const Plot *plot, size_t index);
