/* The view and the plots next to it, and their use by mouse. */
#pragma once

#include "window/window_state.h"

/* Draws the view's picture; call it before the panes. */
void canvas_paint(Window *window);

/* Shows the panes over the pictures: selection, labels, mouse. */
void canvas_show(Window *window);

/* Keeps the plan still where only the tools left of it have come or gone since the frame `before`. */
void canvas_hold_still(Window *window, const Frame *before);
