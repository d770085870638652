/* The two dialogs that ask a question: before edits are lost, and after a crash. */
#pragma once

#include "window/window_state.h"

void dialog_leave_show(Window *window);
void dialog_leave_show_recovered(Window *window);
