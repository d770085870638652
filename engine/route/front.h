/* How long a front takes that spreads over a grid: the fast marching method, see front.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

/* What a front makes of a point. Those that are squeezed take their times from passable ones and give none back. */
typedef enum FrontClass { FRONT_BLOCKED, FRONT_SQUEEZED, FRONT_PASSABLE } FrontClass;

enum { FRONT_MOST_STEPS = 31 };

typedef struct FrontEntry {
    float time; /* s */
    int point;
} FrontEntry;

typedef struct Front {
    int nx, ny;
    double cell;           /* m */
    float *slowness;       /* (ny x nx) s/m, > 0 */
    unsigned char *states; /* (ny x nx) FrontClass, until the front runs */
    float *time;           /* (ny x nx) s, infinite where it has not come; not owned */
    FrontEntry *heap;      /* (heap_count), binary */
    size_t heap_count, heap_capacity;
} Front;

/* All points blocked, all times infinite; the caller fills slowness and states. `time` (ny x nx) has to outlive the
 * front; front_clear releases the rest. */
void front_init(Front *front, int nx, int ny, double cell, float *time);
void front_clear(Front *front);

/* Lets the front start at a passable point at `time` s, the least one that is given; it keeps it. */
void front_give(Front *front, int i, int j, double time);

/* Over the passable points. False: it starts nowhere. */
bool front_run(Front *front);

/* After that from them on over the squeezed points, up to `most_steps` (at most FRONT_MOST_STEPS) points far. */
void front_squeeze(Front *front, int most_steps);

/* The unit vector along which the time falls from a point, towards where it came from; (0, 0): nowhere. */
Vec2 front_downhill(const Front *front, int i, int j);
