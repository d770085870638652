/* Shows what a click at the pointer would do before it is done, for the tools that place one item. The gesture is
 * begun, drawn and cancelled, so that what is shown is what the click does. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Returns what a click would do; NULL: a gesture lasts, or the tool has no preview. Valid until the next call. */
const EditPreview *edit_preview_make(Editor *edit);

void edit_preview_clear(Editor *edit);
