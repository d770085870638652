/* The transport: buttons, clock, the line of time with its marks, speed. */
#pragma once

#include "window/window_state.h"

void timeline_show(Window *window);
