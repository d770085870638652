/* The bars: menu and answer above, what can be pressed below. */
#pragma once

#include "window/window_state.h"

void bars_show_menu(Window *window);
void bars_show_answer(Window *window);

/* The last message, until it is put away; what is being written; and the strip of keys. */
void bars_show_message(Window *window);
void bars_show_strip(Window *window);
