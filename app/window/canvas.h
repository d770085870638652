/* The view and the plots beside it, and what is done to them by mouse. */
#pragma once

#include "window/window_state.h"

/* Draws the pictures; before the panes. */
void canvas_paint(Window *window);

/* The panes over the pictures: selection, words, mouse. */
void canvas_show(Window *window);
