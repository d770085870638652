/* What stands in the way: the outlines of walls, furniture and doors' leaves as straight faces and convex corners.
 *
 * Walls with thickness, furniture and the standing leaves of open doors are united (GEOS), so that no face or corner
 * lies hidden inside something else; each face remembers what it belongs to. The leaf of a door that can be opened
 * comes twice, shut in its opening and open beside it: which of the two counts depends on the door's state.
 *
 *            normal ^
 *                   |
 *        b <------------------ a        the solid lies to the left of a -> b, free space to the right
 *           ////// solid //////
 *
 * A wall of no thickness is two faces back to back. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "mechanics/broadphase.h"
#include "plan/plan.h"

typedef enum Owner { OWNER_WALL, OWNER_FURNITURE, OWNER_DOOR } Owner;

/* When a face or a corner is there. */
typedef enum Presence { PRESENT_ALWAYS, PRESENT_SHUT, PRESENT_OPEN } Presence;

typedef struct Face {
    Vec2 a, b;
    Vec2 normal; /* unit, into free space */
    int owner;   /* Owner */
    int index;   /* of the wall, piece of furniture or door in the plan */
    int door;    /* whose state decides, or -1 */
    int presence;
} Face;

/* A convex corner of a solid, where two faces meet: `in` points along the face that ends here, `out` along the one that
 * begins here. It is what a body touches only from within the wedge of the two faces' normals. */
typedef struct Corner {
    Vec2 at;
    Vec2 in, out; /* unit */
    int owner, index, door, presence;
} Corner;

/* Closed rings one after another, for filling: solids to the left, holes clockwise. Zero is none. */
typedef struct Rings {
    Vec2 *points;   /* (point_count) m; a ring's first point is not repeated */
    size_t *starts; /* (count + 1) of each ring in points; NULL when there is none */
    size_t count, point_count, start_capacity, point_capacity;
} Rings;

typedef struct Outline {
    Face *faces;     /* (face_count) */
    Corner *corners; /* (corner_count) */
    size_t face_count, corner_count;
    Rings rings;            /* of all solids that have a thickness */
    Box box;                /* of everything in the plan, solids, people and exits */
    Broadphase *broadphase; /* items: face i as i, corner j as face_count + j */
} Outline;

#define OUTLINE_LEAF_THICKNESS 0.04 /* m, of a door's leaf: assumed */

/* Builds the outline of a plan. False, with a fault, when GEOS cannot unite it. */
bool outline_build(Outline *outline, const Plan *plan, Fault *fault);
void outline_free(Outline *outline);

/* The rings of those walls alone, doors cut out, that are at least `low` and less than `high` m high. False when GEOS
 * cannot unite them. outline_free_rings releases what is filled. */
bool outline_walls(const Plan *plan, double low, double high, Rings *rings);
void outline_free_rings(Rings *rings);

/* Is the face or corner there when every door that can be opened is open? That is what routes are planned on. */
static inline bool outline_planned(int presence) {
    return presence != PRESENT_SHUT;
}

/* Is the face or corner there when of the doors (each of the plan) those are open? */
static inline bool outline_present(int door, int presence, const bool *door_open) {
    return presence == PRESENT_ALWAYS || door_open[door] == (presence == PRESENT_OPEN);
}

/* Can this door be shut and opened again? */
static inline bool outline_door_moves(const Door *door) {
    return door->kind != DOOR_OPENING && door->state == DOOR_CLOSED;
}

/* Where the ray from `from` along the unit vector `direction` first meets a planned face: its distance, at most
 * `reach` m, and that face in `*face` (-1: none; may be NULL). */
double outline_ray(const Outline *outline, Vec2 from, Vec2 direction, double reach, int *face);

/* The same distance when of the doors those are open. */
double outline_ray_past(const Outline *outline, const bool *door_open, Vec2 from, Vec2 direction, double reach);

/* "door d2", "wall w1", "wardrobe (f3)": what a face belongs to. */
void outline_name(const Plan *plan, int owner, int index, char *name, size_t size);

/* The place's best name for a report: the door whose opening it lies in, otherwise the owner of the nearest face. */
void outline_place_name(const Outline *outline, const Plan *plan, Vec2 at, char *name, size_t size);
