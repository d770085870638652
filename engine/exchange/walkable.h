/* The area of a house in which one can walk, as other programs about people on foot want it. */
#pragma once

#include "base/fault.h"
#include "plan/plan.h"

/* One line of WKT, a POLYGON, or a MULTIPOLYGON where it has several parts (a GEOMETRYCOLLECTION where these meet along
 * a wall of no thickness): the box of the plan, a metre larger, less walls, furniture and the leaves of doors that
 * stand open; doors that are not locked are open. What lies outside a house without a way out is no part of it, nor is
 * what walls of no thickness enclose within the area when nobody stands there: that is an obstacle. New, memory_free
 * it; NULL: a fault. */
char *walkable_wkt(const Plan *plan, Fault *fault);
