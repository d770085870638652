/* The width of a passage, measured by rays. */
#pragma once

#include "base/vec2.h"
#include "space/freespace.h"
#include "space/outline.h"

/* m: the width of a passage is clipped to this; the speed law does not depend on larger widths. */
#define PASSAGE_WIDEST 3.0

/* The two distances from a place on a path to the obstacles across the path. */
typedef struct Passage {
    double left, right; /* m, up to PASSAGE_WIDEST each */
} Passage;

/* Measures the passage; `along` is the unit direction of the path. */
Passage passage_at(const Outline *outline, Vec2 at, Vec2 along);

/* Returns left + right, m. */
static inline double passage_width(Passage passage) {
    return passage.left + passage.right;
}

/* Measures the same, with up to `half` m (at most FREESPACE_BUCKET_REACH) on either side, without the broad phase. */
Passage passage_within(const FreeSpace *space, Vec2 at, Vec2 along, double half);

/* Returns the distance from a convex corner of an obstacle, starting 0.1 mm off it, to the opposite side: W1 or W2 of
 * the paper. `across` is the unit direction from the corner over the passage. */
double passage_across(const Outline *outline, Vec2 corner, Vec2 across);

/* Returns the distance between two faces, m, measured where they are nearest to each other. `*middle` is a place
 * between them, and then the middle of that distance; of parallel faces it is measured beside that place. */
double passage_between(const Face *one, const Face *other, Vec2 *middle);
