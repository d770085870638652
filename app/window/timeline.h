/* The transport: buttons, clock, timeline with its marks, speed. */
#pragma once

#include "window/window_state.h"

void timeline_show(Window *window);
