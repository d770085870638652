/* Stops of the focus, and the keys on their way to them. */
#pragma once

#include "widgets/ui_state.h"

/* Registers a stop; true if it has the focus. */
bool ui_stop_make(Ui *ui, UiId id, UiKind kind, Box box);

/* Does the same for a stop that can be typed into. */
bool ui_stop_make_typed(Ui *ui, UiId id, UiKind kind, Box box, const char *text, const UiSlider *number);
const UiStop *ui_stop_find(const Ui *ui, UiId id);

/* Removes the next key for the stop; false if none is left. */
bool ui_stop_next_key(Ui *ui, UiId id, UiPress *press);

/* True if Enter or Space was pressed on the stop. */
bool ui_stop_used(Ui *ui, UiId id);
/* Stores a key for a stop. */
void ui_stop_press(Ui *ui, UiId id, UiKey key, bool shift);

void ui_stop_draw(Ui *ui); /* the frame of the focus, in the pane that is being made */
