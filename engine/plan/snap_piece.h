/* Snaps furniture to walls and other furniture, turns its back to a wall, and measures gaps. */
#pragma once

#include "plan/snap.h"

/* Moves a piece so that one of its sides touches a face within reach, or otherwise to whole centimetres; ask->at is its
 * middle. The snap's `at` is the new position of the middle. */
Snap snap_piece_place(const Plan *plan, const Furniture *piece, const SnapAsk *ask);

/* Turns a new piece whose middle is at ask->at so that its back stands against the nearest face of a wall within reach.
 * Returns false if there is none. */
bool snap_piece_back(const Plan *plan, const Furniture *piece, const SnapAsk *ask, double *angle, Vec2 *centre);

/* Returns the distance, m, from a place along a direction (unit) to the next wall or piece of furniture that is not
 * excluded; HUGE_VAL: none. Doors count as walls. */
double snap_piece_gap(const Plan *plan, Vec2 from, Vec2 direction, const char *const *without, size_t without_count);
