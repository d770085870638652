/* The picture to trace, on the floor of the plan. */
#pragma once

#include "window/window_state.h"

/* Draws the picture within the view's pane; posts one message about a file that cannot be read. */
void trace_image_show(Window *window);
void trace_image_clear(Window *window);
