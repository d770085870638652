/* The handles of the selected item: points, edges, corners, rotation. */
#pragma once

#include "laboratory/edit/editor_state.h"

enum { EDIT_HANDLES = 128 /* at most this many handles of the selection */ };

/* Lists the handles of the selection in a plan (at most EDIT_HANDLES); returns their number. */
size_t edit_handle_list(const Editor *edit, const Plan *plan, EditHandle *handles);

/* Finds the nearest handle within reach of the pointer; false: none. */
bool edit_handle_at(const Editor *edit, const Pointer *pointer, EditHandle *handle);
