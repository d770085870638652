/* The walking direction and the time to the goal at every place, for round walkers (a floor field).
 *
 * The time is that of a disc's centre, computed by fast marching on the grid of distances (see floor_field.c); the
 * direction is that of its steepest descent. Time counts up to FLOOR_FIELD_DISCOMFORT times more next to an obstacle,
 * so that paths keep off walls and corners where there is room; a closed door costs its opening time. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "route/field.h"
#include "space/freespace.h"
#include "plan/plan.h"

/* A grid of distances with more points than this is thinned, to points at most this far apart. */
#define FLOOR_FIELD_MOST_POINTS 1500000
#define FLOOR_FIELD_COARSEST 0.11 /* m */

/* m: below this clearance, time counts (1 + FLOOR_FIELD_DISCOMFORT (1 - clearance / FLOOR_FIELD_MARGIN)^2) times. */
#define FLOOR_FIELD_MARGIN 0.15
#define FLOOR_FIELD_DISCOMFORT 1.0

/* m: beyond an exit that leads out of the plan, directions continue for this distance, as far as the space is free. */
#define FLOOR_FIELD_BEYOND 0.5

typedef struct FloorFieldExit {
    Vec2 from, along; /* m; unit */
    double length;    /* m */
    int outward;      /* the outer side: +1 left of `along`, -1 right, 0 if the exit is approached from both */
} FloorFieldExit;

typedef struct FloorField {
    const FreeSpace *space; /* not owned */
    Goal goal;
    double radius, speed;   /* m, m/s */
    Vec2 origin;            /* m, of grid point (0, 0) */
    double cell, per_metre; /* m; 1/m, cells in a metre */
    int nx, ny;
    float *time;                  /* (ny x nx) s; negative beyond the goal, infinite without a path */
    signed char (*directions)[2]; /* (ny x nx) unit vectors x 127; (0, 0): none; x INT8_MIN: near a wall or an exit */
    FloorFieldExit *exits;        /* (exit_count) usable exits */
    size_t exit_count;
} FloorField;

/* Computes the times and directions to the goal for a person of `radius` m who walks at `speed` m/s (> 0). Returns
 * false if the goal cannot be reached from anywhere; no place then has a path. `space` and its outline must outlive the
 * field; floor_field_clear releases it in either case. */
bool floor_field_init(FloorField *field, const Plan *plan, const FreeSpace *space, double radius, double speed,
                      const Goal *goal);
void floor_field_clear(FloorField *field);

/* Returns the time from a place to the goal, s, at least 0; HUGE_VAL without a path. */
double floor_field_time(const FloorField *field, Vec2 at);

/* Returns the unit vector to walk along from a place; (0, 0) without a path. Next to an obstacle it leads along or away
 * from the obstacle; next to an exit's line, across the line. A person who is already outside is led to
 * FLOOR_FIELD_BEYOND behind an exit, not across its line. */
Vec2 floor_field_direction(const FloorField *field, Vec2 at);
