/* Lines of text and wrapped texts. */
#pragma once

#include "widgets/ui_state.h"

/* One line in a box, in the middle of its height, shortened where it must be. */
void ui_text_in(Ui *ui, UiTextStyle style, UiInk ink, Box box, double aligned, const char *text);

/* Wrapped words from the top of a box downwards; returns how high they are. Opacity 0 only measures. */
double ui_text_wrapped(Ui *ui, UiTextStyle style, UiInk ink, Box box, const char *text);
