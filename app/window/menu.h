/* The pull-down menus: they open below their words, neither dim nor stop anything, and change while the pointer moves
 * along the bar. */
#pragma once

#include "window/window_state.h"

/* Shows the words of the bar; returns the right edge of the last one. */
double menu_show_bar(Window *window, Box bar);

/* Shows the open menu. */
void menu_show(Window *window);

/* Goes to the next menu to the right or left, or to the next row below or above. */
void menu_walk(Window *window, int across, int down);

/* Goes to the next row of the open menu whose name begins with a small letter; false: there is none. */
bool menu_jump(Window *window, char letter);

/* Returns the box of the open menu, design points; whether its rows do not fit; and the name of its row that has the
 * focus, "": none. */
Box menu_box(Window *window);
bool menu_scrolls(Window *window);
const char *menu_focused(Window *window);
