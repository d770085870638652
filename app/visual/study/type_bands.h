/* Types I, II and III along the foot of a plot of forces, as bands of three heights and colours. */
#pragma once

#include "base/memory.h"
#include "plot/plot.h"

enum { TYPE_BANDS = 3 /* areas that a plot needs room for */ };

/* Adds a band for each value (count, ascending, in the axis' unit) whose type, 1 to 3, is known: it reaches half way to
 * the values beside it, which are `step` apart, and from 0 up to `height` for type III, less for the others. */
void type_bands_add(Plot *plot, const double *values, const double *types, size_t count, double step, double height,
                    Arena *arena);

/* Returns the height of bands in a plot whose series are there: a small part of the largest value. */
double type_bands_height(const Plot *plot);
