/* Draws the editing overlay of the view: the selection, the gesture and its typed fields. */
#pragma once

#include "window/window_state.h"

void plan_overlay_show(Window *window);
