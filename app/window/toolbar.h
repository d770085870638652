/* The toolbar, left of the view. */
#pragma once

#include "window/window_state.h"

void toolbar_show(Window *window);
