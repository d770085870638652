/* Before something is lost, and after something was: the only questions that are asked. */
#pragma once

#include "window/window_state.h"

void dialog_leave_show(Window *window);
void dialog_leave_show_recovered(Window *window);
