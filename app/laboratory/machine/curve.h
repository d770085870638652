/* A series of a plot that grows: points that are added one by one, each with its time. */
#pragma once

#include <stddef.h>

/* A zeroed curve is empty. */
typedef struct MachineCurve {
    double *x, *y, *time; /* (count) s; times never fall */
    size_t count;
    size_t x_capacity, y_capacity, time_capacity;
} MachineCurve;

void machine_curve_add(MachineCurve *curve, double time, double x, double y);
void machine_curve_clear(MachineCurve *curve);

/* Removes all points but keeps the memory. */
static inline void machine_curve_reset(MachineCurve *curve) {
    curve->count = 0;
}

/* Returns how many points are not later than a time. */
size_t machine_curve_count_until(const MachineCurve *curve, double time);

/* Copies to `to` the points of `from` up to a time. */
void machine_curve_copy(MachineCurve *to, const MachineCurve *from, double time);
