/* Where a hand means to point in a house: at an end of a wall, on a wall, in line with something, at an angle of 15
 * degrees, at a whole centimetre. Pure geometry: what is snapped to has a name to be said, and lines to be drawn. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "plan/plan.h"

#define SNAP_GRID 0.01       /* m */
#define SNAP_FREE_GRID 0.001 /* m, of a hand that is free, so that files stay short */
#define SNAP_TURN 15.0       /* degree */

enum { SNAP_WORDS = 96, SNAP_GUIDES = 2 };

/* What is asked for. */
typedef struct SnapAsk {
    Vec2 at;          /* m, where the hand is */
    double reach;     /* m: what is nearer than this is meant */
    bool free;        /* nothing is snapped to */
    bool straight;    /* only along the x or the y axis from `from` */
    bool faces;       /* of walls and furniture, instead of the walls' axes */
    bool doors;       /* the edges of openings, too */
    const Vec2 *from; /* m, the other end of the line that is being drawn, or NULL */
    double along;     /* degree, the direction in which that line's neighbour came to `from`; NAN: none did */
    const Vec2 *own;  /* (own_count) m, points of what is being drawn so far; the first one closes it */
    size_t own_count;
    bool closes;
    const char *const *without; /* (without_count) ids of what moves itself */
    size_t without_count;
} SnapAsk;

/* What is found. */
typedef struct Snap {
    Vec2 at;                /* m */
    char words[SNAP_WORDS]; /* "end of w3", "on w2, 90 degrees"; "": nothing, or the grid */
    Vec2 guides[SNAP_GUIDES][2];
    size_t guide_count;
} Snap;

Snap snap_point(const Plan *plan, const SnapAsk *ask);

/* A length, or a coordinate, without the last digits that turning has left, m. */
double snap_tidy(double value);

/* The unit vector of an angle in degrees: exact along the axes. */
Vec2 snap_heading(double degrees);

/* The direction of a vector, degree: exact along the axes, in (-180, 180]. */
double snap_angle(Vec2 along);

/* An angle to the nearest multiple of SNAP_TURN, or to a tenth of a degree when `free`; in (-180, 180]. */
double snap_turn(double degrees, bool free);

/* A place on a wall's axis. */
typedef struct SnapWall {
    size_t wall, segment;
    double along;    /* m, from the segment's first point */
    double length;   /* m, of the segment */
    double distance; /* m, from the place that was asked for */
} SnapWall;

/* The wall nearest to a place. False: there is none. */
bool snap_wall(const Plan *plan, Vec2 at, SnapWall *nearest);
