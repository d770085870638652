/* A series of a plot that grows: points that are added one by one, each with its time. */
#pragma once

#include <stddef.h>

/* A zeroed curve is empty. */
typedef struct BeamCurve {
    double *x, *y, *time; /* (count) s; times never fall */
    size_t count;
    size_t x_capacity, y_capacity, time_capacity;
} BeamCurve;

void beam_curve_add(BeamCurve *curve, double time, double x, double y);
void beam_curve_clear(BeamCurve *curve);

/* Removes all points but keeps the memory. */
static inline void beam_curve_reset(BeamCurve *curve) {
    curve->count = 0;
}

/* Returns how many points are not later than a time. */
size_t beam_curve_count_until(const BeamCurve *curve, double time);

/* Copies to `to` the points of `from` up to a time. */
void beam_curve_copy(BeamCurve *to, const BeamCurve *from, double time);
