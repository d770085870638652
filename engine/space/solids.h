/* The solids of a plan, before and after GEOS unites them: walls with their doors cut out, furniture, and the leaves of
 * open doors. outline.c derives faces and corners from the union. */
#pragma once

#define GEOS_USE_ONLY_R_API
#include <geos_c.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "mechanics/broadphase.h"
#include "space/outline.h"
#include "plan/plan.h"

/* m: coordinates are united on a grid of this spacing, so that walls that nearly meet do meet. */
#define SOLIDS_GRID 1e-6

/* 1: the sine of the turn below which two edges count as one straight face. */
#define SOLIDS_STRAIGHT 1e-5

/* A solid before the union, stored to find the owner of a face afterwards. */
typedef struct Solid {
    Vec2 corners[4]; /* corners of a convex quadrangle, counter-clockwise */
    int owner, index;
} Solid;

typedef struct Solids {
    const Plan *plan;
    GEOSContextHandle_t geos;
    char message[160];    /* the last error of GEOS, or the reason why nothing was united */
    bool failed;          /* True if a part could not be made */
    GEOSGeometry **parts; /* (part_count) parts to unite */
    size_t part_count, part_capacity;
    Solid *list; /* (count) */
    size_t count, capacity;
    Broadphase *tree; /* tree of the list */
    int *near;        /* (near_capacity) results of a query */
    size_t near_capacity;
    size_t *door_starts;   /* (wall_count + 1) start of each wall in doors_of_wall */
    size_t *doors_of_wall; /* (door_count) doors, wall by wall */
} Solids;

/* Starts without solids. GEOS stores the address, so the value must not move. solids_clear releases it. */
void solids_init(Solids *solids, const Plan *plan);
void solids_clear(Solids *solids);

/* Unites all solids that have a thickness; the caller destroys the geometry. NULL: solids->message gives the reason. */
GEOSGeometry *solids_unite(Solids *solids);

/* Does the same with only the walls that are at least `low` and less than `high` m high. */
GEOSGeometry *solids_unite_walls(Solids *solids, double low, double high);

/* Adds the rings of all polygons of a geometry, straightened. */
void solids_add_rings(const Solids *solids, const GEOSGeometry *geometry, Rings *rings);

/* Returns the part of the line of wall `w`, which has no thickness, outside doors and the united solids; the caller
 * destroys it. NULL: no part is left, or GEOS failed. */
GEOSGeometry *solids_thin_wall(Solids *solids, size_t w, const GEOSGeometry *united);

/* Returns the owner of the face that has its middle here, or NULL. Furniture and leaves precede walls, so that a piece
 * that leans on a wall is found itself. */
const Solid *solids_owner(Solids *solids, Vec2 middle);

/* Fills in the rectangle from a to b, `left` m to the left of that line and `right` m to its right, counter-clockwise.
 */
void solids_strip(Vec2 a, Vec2 b, double left, double right, Vec2 corners[4]);

/* Fills in the leaf of a hinged door that stands open, at a right angle to its wall, from `from_wall` m off the wall's
 * centre line on. The leaf hangs next to the opening and does not narrow it: `width` is the clear width. */
void solids_open_leaf(const Plan *plan, const Door *door, double from_wall, Vec2 corners[4]);

/* Fills in what stays of the leaf of a sliding door in its opening when it is open, at the end of its hinge. */
void solids_rest(const Plan *plan, const Door *door, Vec2 corners[4]);
