/* Edits elements made of points: walls, outlines of rooms, exits, routes. Moving a point of a wall also moves the
 * points of other walls at the same place, so corners stay closed. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Functions of the gesture that drags a point or a segment. */
void edit_shape_update(Editor *edit);
void edit_shape_make(Editor *edit);

/* Moves the whole selection by a vector, m, in the open step: selected walls with the corners of other walls that lie
 * on them, doors along their walls. `plan` is the plan before the move. */
void edit_shape_move(Editor *edit, const Plan *plan, Vec2 by);
