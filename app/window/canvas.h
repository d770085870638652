/* The view and the plots next to it, and their use by mouse. */
#pragma once

#include "window/window_state.h"

/* Draws the view's picture; call it before the panes. */
void canvas_paint(Window *window);

/* Shows the panes over the pictures: selection, labels, mouse. */
void canvas_show(Window *window);
