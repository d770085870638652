/* Stops of the focus, and the keys on their way to them. */
#pragma once

#include "widgets/ui_state.h"

/* Makes a stop; true when it has the focus. */
bool ui_stop_make(Ui *ui, UiId id, UiKind kind, Box box);

/* The same of one that is typed into. */
bool ui_stop_make_typed(Ui *ui, UiId id, UiKind kind, Box box, const char *text, const UiSlider *number);
const UiStop *ui_stop_find(const Ui *ui, UiId id);

/* Takes the next key that was meant for the stop; false: none is left. */
bool ui_stop_next_key(Ui *ui, UiId id, UiPress *press);

/* Has Enter or Space been pressed on it? */
bool ui_stop_used(Ui *ui, UiId id);
/* Stores a key for a stop. */
void ui_stop_press(Ui *ui, UiId id, UiKey key, bool shift);

void ui_stop_draw(Ui *ui); /* the frame, in the pane that is being made */
