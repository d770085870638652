/* Places doors and openings on a wall, slides them along it, and changes their width. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Functions of the gesture that places a door; its fields are x, y, width and the place along the wall. `limit` moves
 * the door to the nearest free place of its segment. */
void edit_door_update(Editor *edit);
void edit_door_make(Editor *edit);
bool edit_door_limit(Editor *edit);

/* Functions of the gesture that drags the middle or an edge of the door `dragged_id`; its fields are the place along
 * the wall and the width. */
void edit_door_slide_update(Editor *edit);
void edit_door_slide_make(Editor *edit);
bool edit_door_slide_limit(Editor *edit);
