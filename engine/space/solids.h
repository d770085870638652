/* What stands in a plan, before and after it is united by GEOS: walls with their doors cut out, furniture and the
 * leaves of doors that stand open. outline.c reads faces and corners off the union. */
#pragma once

#define GEOS_USE_ONLY_R_API
#include <geos_c.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "mechanics/broadphase.h"
#include "space/outline.h"
#include "plan/plan.h"

/* m: coordinates are united on a grid this fine, so that walls that nearly meet do meet. */
#define SOLIDS_GRID 1e-6

/* 1: the sine of the turn below which two edges count as one straight face. */
#define SOLIDS_STRAIGHT 1e-5

/* A solid before the union, to tell afterwards to whom a face belongs. */
typedef struct Solid {
    Vec2 corners[4]; /* of a convex quadrangle, counter-clockwise */
    int owner, index;
} Solid;

typedef struct Solids {
    const Plan *plan;
    GEOSContextHandle_t geos;
    char message[160];    /* the last thing that GEOS complained about, or why nothing was united */
    bool failed;          /* a part could not be made */
    GEOSGeometry **parts; /* (part_count) to be united */
    size_t part_count, part_capacity;
    Solid *list; /* (count) */
    size_t count, capacity;
    Broadphase *tree; /* of the list */
    int *near;        /* (near_capacity) what a query has found */
    size_t near_capacity;
    size_t *door_starts;   /* (wall_count + 1) of each wall in doors_of_wall */
    size_t *doors_of_wall; /* (door_count) wall by wall */
} Solids;

/* Nothing stands yet; GEOS keeps the address, so it must not move. solids_clear releases it. */
void solids_init(Solids *solids, const Plan *plan);
void solids_clear(Solids *solids);

/* All that has a thickness, united; the caller destroys it. NULL: solids->message says why not. */
GEOSGeometry *solids_unite(Solids *solids);

/* The same of the walls alone that are at least `low` and less than `high` m high. */
GEOSGeometry *solids_unite_walls(Solids *solids, double low, double high);

/* Adds the rings of all polygons of a geometry, straightened. */
void solids_add_rings(const Solids *solids, const GEOSGeometry *geometry, Rings *rings);

/* What of the line of wall `w`, which has no thickness, is neither door nor inside the united solids; the caller
 * destroys it. NULL: nothing, or GEOS could not tell. */
GEOSGeometry *solids_thin_wall(Solids *solids, size_t w, const GEOSGeometry *united);

/* Whose face it is that has its middle here, or NULL. Furniture and leaves come before walls: what leans on a wall is
 * named itself. */
const Solid *solids_owner(Solids *solids, Vec2 middle);

/* The rectangle from a to b, `left` m to the left of that line and `right` m to its right, counter-clockwise. */
void solids_strip(Vec2 a, Vec2 b, double left, double right, Vec2 corners[4]);

/* The leaf of a hinged door that stands open, at a right angle to its wall, from `from_wall` m off the wall's centre
 * line on. It hangs beside the opening and does not narrow it: `width` is what is clear. */
void solids_open_leaf(const Plan *plan, const Door *door, double from_wall, Vec2 corners[4]);
