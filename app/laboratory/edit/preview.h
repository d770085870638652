/* Shows what a click at the pointer would do before it is done, for the tools that place one item. The gesture is
 * begun, drawn and cancelled, so that what is shown is what the click does. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Adds the marks of the preview to the displayed ones; NULL: the tool has none. The result is valid until the next
 * call.
 */
const EditPreview *edit_preview_show(Editor *edit);

void edit_preview_clear(Editor *edit);
