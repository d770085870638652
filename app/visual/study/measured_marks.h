/* Points that somebody has measured, laid over a plot as open marks. */
#pragma once

#include "plot/plot.h"
#include "exchange/measured.h"

/* What an axis shows of a quantity. */
typedef struct MeasuredAxis {
    const char *name; /* of the quantity, as in Measured */
    double factor;    /* from its unit to the axis' */
} MeasuredAxis;

/* Adds a series of the points that have both quantities, if there are any, called `name`, in the shape number `shape`;
 * `plot` has room for it and the arena holds what it shows. `measured` may be NULL: no points. False: there are none.
 */
bool measured_marks_add(Plot *plot, const Measured *measured, MeasuredAxis x, MeasuredAxis y, const char *name,
                        size_t shape, Arena *arena);
