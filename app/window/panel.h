/* The panel: what is selected, what came of the run, what may be chosen, every number that can be changed. */
#pragma once

#include "window/window_state.h"

void panel_show(Window *window);
