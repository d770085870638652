/* The walkable area of a house, for other pedestrian programs. */
#pragma once

#include "base/fault.h"
#include "plan/plan.h"

/* Returns one line of WKT: a POLYGON, or a MULTIPOLYGON if the area has several parts (a GEOMETRYCOLLECTION where
 * parts meet along a wall of zero thickness). The area is the plan's box, extended by 1 m, without walls, furniture
 * and the leaves of open doors; doors that are not locked count as open. The outside of a house without an exit is
 * left out, and so is an uninhabited area enclosed by walls of zero thickness, which is an obstacle. The caller
 * releases the text with memory_free; NULL after an error. */
char *walkable_wkt(const Plan *plan, Fault *fault);
