/* Arrival times of a front that spreads over a grid, by the fast marching method: see fast_marching.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "route/buckets.h"

/* How a front treats a point. Squeezed points take their times from passable ones and give none back. */
typedef enum FastMarchingClass {
    FAST_MARCHING_BLOCKED,
    FAST_MARCHING_SQUEEZED,
    FAST_MARCHING_PASSABLE
} FastMarchingClass;

enum { FAST_MARCHING_MOST_STEPS = 31 };

typedef struct FastMarchingEntry {
    float time; /* s */
    int point;
} FastMarchingEntry;

typedef struct FastMarching {
    int nx, ny;
    double cell;             /* m */
    float *slowness;         /* (ny x nx) s/m, > 0 */
    unsigned char *states;   /* (ny x nx) FastMarchingClass until the front runs */
    float *time;             /* (ny x nx) s, infinite where the front has not arrived; not owned */
    FastMarchingEntry *heap; /* (heap_count) points that are not final, the first of all on top */
    size_t heap_count, heap_capacity;
    Buckets later; /* points after those of bucket `number`; zero before the front runs */
    size_t number;
} FastMarching;

/* Makes all points blocked and all times infinite; the caller fills in slowness and states. `time` (ny x nx) must
 * outlive the front; fast_marching_clear releases the rest. */
void fast_marching_init(FastMarching *front, int nx, int ny, double cell, float *time);
void fast_marching_clear(FastMarching *front);

/* Starts the front at a passable point at `time` s; the least given time counts, and it stays fixed. */
void fast_marching_seed(FastMarching *front, int i, int j, double time);

/* Spreads the front over the passable points. Returns false if it starts nowhere. */
bool fast_marching_run(FastMarching *front);

/* Then spreads from the passable points over the squeezed points, up to `most_steps` (at most FAST_MARCHING_MOST_STEPS)
 * points far. */
void fast_marching_squeeze(FastMarching *front, int most_steps);

/* Returns the unit vector along which the time falls from a point, towards the front's origin; (0, 0): no time. */
Vec2 fast_marching_downhill(const FastMarching *front, int i, int j);
