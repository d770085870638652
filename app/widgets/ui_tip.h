/* Tooltips. */
#pragma once

#include "widgets/ui_state.h"

/* Sets the tooltip of a widget if it is hovered or focused. */
void ui_tip_offer(Ui *ui, UiId id, Box box, const char *help, bool hovered, bool focused);
void ui_tip_frame_begin(Ui *ui);
void ui_tip_draw(Ui *ui);
bool ui_tip_hide(Ui *ui);
bool ui_tip_comes(const Ui *ui); /* or hides by itself */
