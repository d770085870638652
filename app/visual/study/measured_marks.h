/* Measured points, laid over a plot as open marks. */
#pragma once

#include "plot/plot.h"
#include "exchange/measured.h"

/* The quantity that an axis shows. */
typedef struct MeasuredAxis {
    const char *name; /* of the quantity, as in Measured */
    double factor;    /* from its unit to that of the axis */
} MeasuredAxis;

/* Adds a series of the points that have both quantities, if there are any, called `name`, in the shape number `shape`;
 * `plot` must have room for it and the arena holds its data. `measured` may be NULL: no points. False if there are
 * none. */
bool measured_marks_add(Plot *plot, const Measured *measured, MeasuredAxis x, MeasuredAxis y, const char *name,
                        size_t shape, Arena *arena);
