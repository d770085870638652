/* The toolbar, left of the view, and the buttons at the right of the answer: what is missing, or what can be shown of
 * the result. */
#pragma once

#include "window/window_state.h"

void toolbar_show(Window *window);

/* Shows the buttons in the bar of the answer, those of the result unless it is hidden; returns where the room for the
 * words ends. */
double toolbar_show_answer(Window *window, Tab *tab, Box bar, const Result *answer, bool hides);
