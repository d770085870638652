/* How long a front takes that spreads over a grid: the fast marching method, see front.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

/* What a front makes of a point. Those that are squeezed take their times from passable ones and give none back. */
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
    unsigned char *states;   /* (ny x nx) FastMarchingClass, until the front runs */
    float *time;             /* (ny x nx) s, infinite where it has not come; not owned */
    FastMarchingEntry *heap; /* (heap_count), binary */
    size_t heap_count, heap_capacity;
} FastMarching;

/* All points blocked, all times infinite; the caller fills slowness and states. `time` (ny x nx) has to outlive the
 * front; fast_marching_clear releases the rest. */
void fast_marching_init(FastMarching *front, int nx, int ny, double cell, float *time);
void fast_marching_clear(FastMarching *front);

/* Lets the front start at a passable point at `time` s, the least one that is given; it keeps it. */
void fast_marching_seed(FastMarching *front, int i, int j, double time);

/* Over the passable points. False: it starts nowhere. */
bool fast_marching_run(FastMarching *front);

/* After that from them on over the squeezed points, up to `most_steps` (at most FAST_MARCHING_MOST_STEPS) points far.
 */
void fast_marching_squeeze(FastMarching *front, int most_steps);

/* The unit vector along which the time falls from a point, towards where it came from; (0, 0): nowhere. */
Vec2 fast_marching_downhill(const FastMarching *front, int i, int j);
