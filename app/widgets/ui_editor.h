/* The one text that is being typed, and the invalid numbers that were typed (drafts). */
#pragma once

#include "widgets/ui_state.h"

/* Opens with all text selected. Closing with an invalid number leaves the field open (entered) or stores the number as
 * a draft (left). */
void ui_editor_open(Ui *ui, UiId id, const char *text);
void ui_editor_close(Ui *ui, UiEnd end);
void ui_editor_clear(Ui *ui);
void ui_editor_key(Ui *ui, UiKey key, bool shift, bool control);

/* Draws the text that is being typed in a field's box; the mouse moves the caret. */
void ui_editor_draw(Ui *ui, Box box, UiTouch touch);

/* Returns how typing into the widget has ended since the last frame; NULL: it has not. */
const UiTyped *ui_editor_ended(const Ui *ui, UiId id);

/* Returns the draft of a widget, or NULL. */
UiDraft *ui_editor_draft(const Ui *ui, UiId id);
void ui_editor_drop_draft(Ui *ui, UiId id);
