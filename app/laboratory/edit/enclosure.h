/* Finds the room that walls enclose round a place, for a double click with the room tool. */
#pragma once

#include "plan/plan.h"

/* Writes the outline on the walls' axes, counter-clockwise, at most `most` points, m; doors count as walls. Returns its
 * number of points; 0: walls do not enclose the place. */
size_t enclosure_find(const Plan *plan, Vec2 at, Vec2 *points, size_t most);
