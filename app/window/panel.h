/* The panel: the selection, the results, the choices, and every parameter that can be changed. */
#pragma once

#include "window/window_state.h"

void panel_show(Window *window);

/* Shows the handle that opens a closed panel, and closes one that lies over the view. */
void panel_show_handle(Window *window);

/* Reads how the folds of the panel were left, from the settings. */
void panel_read_folds(Window *window);
