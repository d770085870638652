/* Furniture beside walls and other furniture: where it snaps to, where its back goes, what room it leaves. */
#pragma once

#include "plan/snap.h"

/* Moves a piece so that a side of it touches a face within reach of it, or else to whole centimetres; ask->at is its
 * middle. The snap's `at` is where the middle goes. */
Snap snap_piece_place(const Plan *plan, const Furniture *piece, const SnapAsk *ask);

/* Turns a new piece whose middle would be at ask->at so that its back stands against the nearest face of a wall, when
 * it is within reach of that. False: none is. */
bool snap_piece_back(const Plan *plan, const Furniture *piece, const SnapAsk *ask, double *angle, Vec2 *centre);

/* How far it is from a place along a direction (unit) to the next wall or piece of furniture but those that are left
 * out, m; HUGE_VAL: there is none. Doors count as wall. */
double snap_piece_gap(const Plan *plan, Vec2 from, Vec2 direction, const char *const *without, size_t without_count);
