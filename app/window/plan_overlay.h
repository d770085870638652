/* What is seen of editing over the view: what is selected, what is in the hand, and what is typed. */
#pragma once

#include "window/window_state.h"

void plan_overlay_show(Window *window);
