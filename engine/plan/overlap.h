/* Finds furniture that stands in a wall. Real plans contain it, since walls are drawn thicker than they are and
 * wardrobes deeper, so it is reported as a warning, not an error. */
#pragma once

#include "plan/plan.h"

#define OVERLAP_LEAST 0.01 /* m: smaller overlaps are not reported */

/* Returns how deep a piece stands in walls, m, without doorways: the shortest shift out of the deepest wall, whose
 * index goes to `*wall`. 0: no overlap. */
double overlap_depth(const Plan *plan, const Furniture *piece, size_t *wall);
