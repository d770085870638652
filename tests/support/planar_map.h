/* Maps of the plane as something that repeats, for tests of engine/cycle: one cycle is one application of the map,
 * whose orbits, multipliers and exponents are known. */
#pragma once

#include "cycle/cycle.h"

typedef struct PlanarMap {
    /* Moves the point (x, y) and writes the derivative (2 x 2, column by column) at the old one. */
    void (*move)(const void *numbers, double *point, double *derivative);
    const double *numbers; /* of the map */
    double diverges;       /* a coordinate beyond it ends the motion; 0: none does */
} PlanarMap;

/* The map as a cycle, which it must outlive. The peak of a cycle is |x|, the deflection x and the velocity y. */
Cycle planar_map_cycle(const PlanarMap *map);

/* x' = r x (1 - x); y follows x at once. numbers: r. */
void planar_map_logistic(const void *numbers, double *point, double *derivative);

/* x' = 1 + r (x - 1) - (x - 1)^3; y follows x at once. numbers: r. */
void planar_map_cubic(const void *numbers, double *point, double *derivative);

/* Henon's map x' = 1 - a x^2 + y, y' = b x. numbers: a, b. */
void planar_map_henon(const void *numbers, double *point, double *derivative);

/* The delayed logistic map x' = r x (1 - y), y' = x. numbers: r. */
void planar_map_delayed(const void *numbers, double *point, double *derivative);

/* A rotation by `turn` (in whole turns), after which a point comes nearer to the circle of radius 1, at `rate` per
 * cycle. numbers: turn, rate. */
void planar_map_ring(const void *numbers, double *point, double *derivative);

/* A rotation by `turn` whole turns that shrinks by `factor`. numbers: turn, factor. */
void planar_map_spiral(const void *numbers, double *point, double *derivative);

/* The oscillator x'' + x = sin(omega t), whose velocity v becomes -r v where x reaches the gap, once in a period of
 * the drive; y is its velocity. numbers: gap, omega, r. */
void planar_map_impact(const void *numbers, double *point, double *derivative);
