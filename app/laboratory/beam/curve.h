/* Points that come one by one, each with its time: a series of a plot that grows. */
#pragma once

#include <stddef.h>

/* Zero is empty. */
typedef struct BeamCurve {
    double *x, *y, *time; /* (count) s; times never fall */
    size_t count;
    size_t x_capacity, y_capacity, time_capacity;
} BeamCurve;

void beam_curve_add(BeamCurve *curve, double time, double x, double y);
void beam_curve_clear(BeamCurve *curve);

/* No points, but their room. */
static inline void beam_curve_reset(BeamCurve *curve) {
    curve->count = 0;
}

/* Returns how many points are not later than a time. */
size_t beam_curve_until(const BeamCurve *curve, double time);

/* Makes `to` what is there of `from` at a time. */
void beam_curve_copy(BeamCurve *to, const BeamCurve *from, double time);
