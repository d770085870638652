/* The outline of a wall as it is seen: its pieces between the doors. */
#pragma once

#include <stddef.h>

#include "plan/plan.h"

/* Fills in the pieces of a wall of a plan, along one face and back along the other, each at least `least` thick (m) and
 * parted from the next by a point that is not a number; a wall without doors is one piece, and so is one whose pieces
 * have more points than `most`. Returns the number of points, at most `most`. */
size_t wall_outline_write(const Plan *plan, size_t wall, double least, Vec2 *points, size_t most);
