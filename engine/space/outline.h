/* Obstacles: the outlines of walls, furniture and doors' leaves as straight faces and convex corners.
 *
 * Walls with thickness, furniture and the standing leaves of open doors are united (GEOS), so that no face or corner is
 * hidden inside another solid; each face stores its owner. The leaf of a door that can be opened occurs twice, shut in
 * its opening and open next to it; the door's state decides which one is present.
 *
 *            normal ^
 *                   |
 *        b <------------------ a        the solid lies to the left of a -> b, free space to the right
 *           ////// solid //////
 *
 * A wall without thickness has two faces back to back. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "mechanics/broadphase.h"
#include "plan/plan.h"

typedef enum Owner { OWNER_WALL, OWNER_FURNITURE, OWNER_DOOR } Owner;

/* The door states in which a face or a corner is present. */
typedef enum Presence { PRESENT_ALWAYS, PRESENT_SHUT, PRESENT_OPEN } Presence;

typedef struct Face {
    Vec2 a, b;
    Vec2 normal; /* unit, into free space */
    int owner;   /* Owner */
    int index;   /* of the wall, piece of furniture or door in the plan */
    int door;    /* door whose state decides, or -1 */
    int presence;
} Face;

/* A convex corner of a solid, where two faces meet: `in` points along the face that ends here, `out` along the one that
 * begins here. A body touches the corner only from within the wedge of the two faces' normals. */
typedef struct Corner {
    Vec2 at;
    Vec2 in, out; /* unit */
    int owner, index, door, presence;
} Corner;

/* Closed rings for filling, one after another: solids on the left, holes clockwise. A zeroed value has no ring. */
typedef struct Rings {
    Vec2 *points;   /* (point_count) m; a ring's first point is not repeated */
    size_t *starts; /* (count + 1) start of each ring in points; NULL when there is none */
    size_t count, point_count, start_capacity, point_capacity;
} Rings;

typedef struct Outline {
    Face *faces;     /* (face_count) */
    Corner *corners; /* (corner_count) */
    size_t face_count, corner_count;
    Rings rings;            /* outlines of all solids that have a thickness */
    Box box;                /* around everything in the plan: solids, people and exits */
    Broadphase *broadphase; /* items: face i as i, corner j as face_count + j */
} Outline;

/* Builds the outline of a plan. Returns false after an error if GEOS cannot unite the solids. */
bool outline_build(Outline *outline, const Plan *plan, Fault *fault);
void outline_free(Outline *outline);

/* Fills in the rings of only those walls, doors cut out, that are at least `low` and less than `high` m high. Returns
 * false if GEOS cannot unite them. outline_free_rings releases the rings. */
bool outline_walls(const Plan *plan, double low, double high, Rings *rings);
void outline_free_rings(Rings *rings);

/* True if the face or corner is present when every door that can be opened is open. Routes are planned in that state.
 */
static inline bool outline_planned(int presence) {
    return presence != PRESENT_SHUT;
}

/* True if the face or corner is present in the given state of the doors (one per door of the plan). */
static inline bool outline_present(int door, int presence, const bool *door_open) {
    return presence == PRESENT_ALWAYS || door_open[door] == (presence == PRESENT_OPEN);
}

/* True if this door can be shut and opened again. */
static inline bool outline_door_moves(const Door *door) {
    return door->kind != DOOR_OPENING && door->state == DOOR_CLOSED;
}

/* Returns the distance at which the ray from `from` along the unit vector `direction` first meets a planned face, at
 * most `reach` m, and that face in `*face` (-1: none; may be NULL). */
double outline_ray(const Outline *outline, Vec2 from, Vec2 direction, double reach, int *face);

/* Returns the same distance in the given state of the doors. */
double outline_ray_past(const Outline *outline, const bool *door_open, Vec2 from, Vec2 direction, double reach);

/* Writes the name of a face's owner: "door d2", "wall w1", "wardrobe (f3)". */
void outline_name(const Plan *plan, int owner, int index, char *name, size_t size);

/* Returns the door in whose opening a place lies, or -1. */
int outline_door_at(const Plan *plan, Vec2 at);

#define OUTLINE_FREE_SPACE "free space"

/* Writes the best name of a place for a report: the door whose opening contains the place, otherwise the owner of the
 * nearest face, or OUTLINE_FREE_SPACE where no face is near. */
void outline_place_name(const Outline *outline, const Plan *plan, Vec2 at, char *name, size_t size);
