/* Which way to walk from every place, and how long it takes: what round walkers follow.
 *
 * The time to the goal for the centre of a disc, by fast marching on the grid of distances (see floor_field.c), and the
 * direction in which it falls. Time counts up to FLOOR_FIELD_DISCOMFORT times more next to an obstacle, so that ways
 * keep off walls and corners where there is room; a closed door costs its opening time. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "route/field.h"
#include "space/freespace.h"
#include "plan/plan.h"

/* The grid of distances is thinned, to points at most so far apart, when it has more points than these. */
#define FLOOR_FIELD_MOST_POINTS 1500000
#define FLOOR_FIELD_COARSEST 0.11 /* m */

/* Below so much clearance, m, time counts more: (1 + FLOOR_FIELD_DISCOMFORT (1 - clearance / FLOOR_FIELD_MARGIN)^2)
 * times. */
#define FLOOR_FIELD_MARGIN 0.15
#define FLOOR_FIELD_DISCOMFORT 1.0

/* Beyond an exit that leads out of the plan, directions lead on for so much, m, as far as it is free. */
#define FLOOR_FIELD_BEYOND 0.5

typedef struct FloorFieldExit {
    Vec2 from, along; /* m; unit */
    double length;    /* m */
    int outward;      /* the side that is outside: +1 left of `along`, -1 right, 0 it is approached from both */
} FloorFieldExit;

typedef struct FloorField {
    const FreeSpace *space; /* not owned */
    Goal goal;
    double radius, speed;   /* m, m/s */
    Vec2 origin;            /* m, of grid point (0, 0) */
    double cell, per_metre; /* m; 1/m, cells in a metre */
    int nx, ny;
    float *time;                  /* (ny x nx) s; negative where the goal is passed already, infinite: no way */
    signed char (*directions)[2]; /* (ny x nx) unit vectors times 127; (0, 0) none; x INT8_MIN: by a wall or an exit */
    FloorFieldExit *exits;        /* (exit_count) that are usable */
    size_t exit_count;
} FloorField;

/* Builds the times and directions to the goal for somebody of `radius` m who walks `speed` m/s (> 0). False: the goal
 * cannot be reached from anywhere, and every answer is "no way". `space` and its outline have to outlive the
 * field; floor_field_clear releases it in either case. */
bool floor_field_init(FloorField *field, const Plan *plan, const FreeSpace *space, double radius, double speed,
                      const Goal *goal);
void floor_field_clear(FloorField *field);

/* The time from a place to the goal, s, 0 and more; HUGE_VAL where there is no way. */
double floor_field_time(const FloorField *field, Vec2 at);

/* The unit vector to walk along from a place; (0, 0) where there is no way. Next to an obstacle it leads along it or
 * away from it; next to an exit's line, across it. Somebody who is outside already is led to FLOOR_FIELD_BEYOND behind
 * an exit, not across its line. */
Vec2 floor_field_direction(const FloorField *field, Vec2 at);
