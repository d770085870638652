/* What is seen of editing over the view: what is selected, what is in the hand, and what is typed. */
#pragma once

#include "window/window_state.h"

void edit_marks_show(Window *window);
