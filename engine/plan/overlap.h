/* Furniture that stands in a wall. Real plans have it, for walls are drawn thicker than they are and wardrobes deeper:
 * it is remarked, and is no fault. */
#pragma once

#include "plan/plan.h"

#define OVERLAP_LEAST 0.01 /* m: what is less is not remarked */

/* How deep a piece stands in walls, doorways apart, m: the shortest way out of the one it is deepest in, whose index
 * goes to `*wall`. 0: it stands free. */
double overlap_depth(const Plan *plan, const Furniture *piece, size_t *wall);
