/* Shows what a click at the pointer would do before it is done. Of tools that place one item the gesture is
 * begun, drawn and cancelled, so that what is shown is what the click does; others say what begins at the pointer. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Returns what a click would do; NULL: a gesture lasts, or nothing is placed. Valid until the next call. */
const EditPreview *edit_preview_make(Editor *edit);

void edit_preview_clear(Editor *edit);
