/* The faces near a place, as measurements see them: walls alone, or everything that stands in a house whose doors that
 * can be opened are open. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "space/outline.h"

typedef struct Surroundings {
    const Outline *outline;
    const bool *rails; /* which pieces of furniture are rails; NULL: none */
    int *items;        /* (capacity) of queries */
    size_t capacity, count;
} Surroundings;

/* The faces of walls; with the leaves of doors; of rails alone; or of all solids except the leaf of a door, `but_door`
 * (-1: none). */
typedef enum SeenFaces { SEE_WALLS, SEE_WALLS_AND_LEAVES, SEE_RAILS, SEE_ALL } SeenFaces;

void surroundings_clear(Surroundings *near);

/* Finds what may be within `reach` m (in both coordinates) of a place. */
void surroundings_look(Surroundings *near, Vec2 at, double reach);

/* Returns the i-th face, or NULL if it is not seen. */
const Face *surroundings_face(const Surroundings *near, size_t i, SeenFaces seen, int but_door);

/* Returns how far, m, the ray from `from` along the unit vector `along` goes before a seen face, at most `reach`. */
double surroundings_ray(const Surroundings *near, Vec2 from, Vec2 along, double reach, SeenFaces seen);

/* Finds the point of the seen faces that is nearest within `reach` m. Returns false if it is a corner, or if there is
 * none. */
bool surroundings_nearest(const Surroundings *near, Vec2 at, double reach, SeenFaces seen, Vec2 *nearest);

/* A frame of axes: `along` is unit, and the other axis points to its left. */
typedef struct RuleFrame {
    Vec2 origin, along;
} RuleFrame;

/* The part of the frame's plane between two bounds of its coordinates. */
typedef struct RuleStrip {
    double low, high; /* m */
} RuleStrip;

/* Clips a face to the strip of its second coordinate (left of `along`), open by a hair at both ends. Returns false if
 * nothing is left; `u` are the bounds of its first coordinate there. */
bool surroundings_clip(const Face *face, RuleFrame frame, RuleStrip strip, RuleStrip *u);
