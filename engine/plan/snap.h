/* Snaps the pointer in a house: to an end of a wall, onto a wall, in line with an element, to an angle of 15 degrees,
 * to a whole centimetre. Pure geometry; the target has a text, and lines to draw. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "plan/plan.h"

#define SNAP_GRID 0.01       /* m */
#define SNAP_FREE_GRID 0.001 /* m, of a free pointer, so that files stay short */
#define SNAP_TURN 15.0       /* degree */

enum { SNAP_TEXT = 192, SNAP_NAME = 64, SNAP_GUIDES = 2 };

/* Writes the name of an element of a plan near a place, m. */
typedef void (*SnapNames)(const Plan *plan, const char *id, Vec2 at, char name[SNAP_NAME]);

/* Arguments of a snap. */
typedef struct SnapAsk {
    Vec2 at;          /* m, position of the pointer */
    double reach;     /* m: targets within this distance count */
    bool free;        /* True: snap to nothing */
    bool straight;    /* True: only along the x or the y axis from `from` */
    bool faces;       /* True: to faces of walls and furniture instead of the walls' axes */
    bool doors;       /* True: also to the edges of openings */
    const Vec2 *from; /* m, the other end of the line being drawn, or NULL */
    double along;     /* degree, the direction in which the previous line came to `from`; NAN: none */
    const Vec2 *own;  /* (own_count) m, points drawn so far; the first one closes the line */
    size_t own_count;
    bool closes;
    const char *const *without; /* (without_count) ids of moving elements, which are excluded */
    size_t without_count;
    SnapNames names; /* names of the targets; NULL: their ids */
} SnapAsk;

/* Result of a snap. */
typedef struct Snap {
    Vec2 at;              /* m */
    char text[SNAP_TEXT]; /* "end of porch wall", "on w2, 90 degrees"; "": no target, or the grid */
    Vec2 guides[SNAP_GUIDES][2];
    size_t guide_count;
} Snap;

Snap snap_point(const Plan *plan, const SnapAsk *ask);

/* Writes the name of a target at a place, m, as `names` of the arguments says. */
void snap_name(const Plan *plan, const SnapAsk *ask, const char *id, Vec2 at, char name[SNAP_NAME]);

/* Returns a length or a coordinate, m, without the last digits that a rotation has left. */
double snap_tidy(double value);

/* Returns the unit vector of an angle in degrees, exact along the axes. */
Vec2 snap_heading(double degrees);

/* Returns the direction of a vector, degree, exact along the axes, in (-180, 180]. */
double snap_angle(Vec2 along);

/* Rounds an angle to the nearest multiple of SNAP_TURN, or to a tenth of a degree when `free`; in (-180, 180]. */
double snap_turn(double degrees, bool free);

/* A place on a wall's axis. */
typedef struct SnapWall {
    size_t wall, segment;
    double along;    /* m, from the segment's first point */
    double length;   /* m, of the segment */
    double distance; /* m, from the requested place */
} SnapWall;

/* Finds the wall nearest to a place. Returns false if there is none. */
bool snap_wall(const Plan *plan, Vec2 at, SnapWall *nearest);
