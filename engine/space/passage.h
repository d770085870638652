/* The width of a passage, measured by rays through the broad phase. */
#pragma once

#include "base/vec2.h"
#include "space/outline.h"

/* m: a passage is never called wider; beyond it the speed law does not care. */
#define PASSAGE_WIDEST 3.0

/* From a place on the way, both widths to the obstacles across it. */
typedef struct Passage {
    double left, right; /* m, up to PASSAGE_WIDEST each */
} Passage;

/* `along` is the unit direction of the way. */
Passage passage_at(const Outline *outline, Vec2 at, Vec2 along);

/* left + right */
static inline double passage_width(Passage passage) {
    return passage.left + passage.right;
}

/* From a convex corner of an obstacle, standing off it by a hair, to the opposite side: W1 or W2 of the paper. `across`
 * is the unit direction from the corner over the passage. */
double passage_across(const Outline *outline, Vec2 corner, Vec2 across);
