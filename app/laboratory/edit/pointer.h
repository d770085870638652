/* The pointer and the keys, as in editor.h: decides which of them begins, moves and ends each gesture. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Changes the tool; the points drawn so far stay. */
void edit_pointer_set_tool(Editor *edit, EditTool tool);
void edit_pointer_move(Editor *edit, const Pointer *pointer);
void edit_pointer_press(Editor *edit, const Pointer *pointer, bool twice);
void edit_pointer_release(Editor *edit, const Pointer *pointer);
bool edit_pointer_type(Editor *edit, const char *characters);
bool edit_pointer_nudge(Editor *edit, Vec2 by); /* moves the typed place */
bool edit_pointer_enter(Editor *edit);
bool edit_pointer_back(Editor *edit);
bool edit_pointer_escape(Editor *edit);
