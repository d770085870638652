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
