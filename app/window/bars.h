/* The bars: menu and result at the top, messages and shortcut keys at the bottom. */
#pragma once

#include "window/window_state.h"

void bars_show_menu(Window *window);
void bars_show_answer(Window *window);

/* True if the answer of a presentation needs a line below its title. */
bool bars_answer_is_tall(Window *window);

/* Show the last message until it is dismissed, or the progress of an export; and the strip of keys. */
void bars_show_message(Window *window);
void bars_show_strip(Window *window);
