/* The dialog that asks how large an imported plan is, when nothing in its file is sure of the unit. */
#pragma once

#include "window/window_state.h"

void dialog_unit_show(Window *window);
