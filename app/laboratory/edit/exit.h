/* Places exits: across a door, across the gap between the ends of two walls, or across a new door in a solid wall.
 * Nowhere else, so that no exit made by hand lies where nobody can pass. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Functions of the gesture that places an exit; its fields are x, y and the width of a new door. */
void edit_exit_update(Editor *edit);
const char *edit_exit_refuse(const Editor *edit); /* NULL: an exit can lie there */
void edit_exit_make(Editor *edit);
bool edit_exit_limit(Editor *edit);
void edit_exit_describe(const Editor *edit, Text *text);
void edit_exit_promise(const Editor *edit, Text *text); /* what a click does */
void edit_exit_show(Editor *edit);

/* Fills in the middle of the opening on which the first exit lies, m; false: there is none, or there are several. */
bool edit_exit_only(const Editor *edit, Vec2 *at);

/* Marks the doors and gaps on which the first exit could lie, at most a few. */
void edit_exit_rings(Editor *edit);
