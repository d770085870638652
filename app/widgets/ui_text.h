/* Lines of text and wrapped texts. */
#pragma once

#include "widgets/ui_state.h"

/* Draws one line in a box, vertically centred, shortened if needed. */
void ui_text_in(Ui *ui, UiTextStyle style, UiInk ink, Box box, double aligned, const char *text);

/* Draws the start of a text, as much as has room: a field shows the rest when it is opened. */
void ui_text_start(Ui *ui, UiTextStyle style, UiInk ink, Box box, const char *text);

/* Draws wrapped text from the top of a box downwards; returns its height. Opacity 0 only measures. */
double ui_text_wrapped(Ui *ui, UiTextStyle style, UiInk ink, Box box, const char *text);
