/* Drags a handle or the whole selection, and draws the selection rectangle. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* How a handle is grabbed. */
typedef enum EditGrab { GRAB_DRAG, GRAB_CLICK, GRAB_KEYS } EditGrab;

/* Begin to drag a handle, the whole selection, or a selection rectangle from the press position. */
void edit_drag_begin(Editor *edit, const EditHandle *handle, EditGrab how);
void edit_drag_whole(Editor *edit);
void edit_drag_box(Editor *edit);
