/* The picture to trace over, on the floor of what is edited. */
#pragma once

#include "window/window_state.h"

/* Draws it over the view, within the view's pane; a file that cannot be read is said once. */
void trace_image_show(Window *window);
void trace_image_clear(Window *window);
