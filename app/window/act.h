/* What each action does. */
#pragma once

#include "window/window_state.h"

/* Does it, as asked for by a key (its code and mods) or, with 0, by a menu or a button. */
void act_do(Window *window, Action action, int32_t key, int mods);

/* Selects the first row's place, the most dangerous one, shows it from near and goes to its time. */
void act_show_place(Window *window);
