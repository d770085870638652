/* Tooltips. */
#pragma once

#include "widgets/ui_state.h"

/* Tells the help of a widget that was made. */
void ui_tip_offer(Ui *ui, UiId id, Box box, const char *help, bool hovered, bool focused);
void ui_tip_frame_begin(Ui *ui);
void ui_tip_draw(Ui *ui);
bool ui_tip_hide(Ui *ui);
bool ui_tip_comes(const Ui *ui); /* or goes, by itself */
