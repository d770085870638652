/* Carries out the actions of the key table. */
#pragma once

#include "window/window_state.h"

/* Does an action that a key (its code and mods) or, with 0, a menu or a button asks for. */
void act_do(Window *window, Action action, int32_t key, int mods);

/* Takes the tool for what the house of a tab lacks, as the answer says, and goes on with it there: editor_cure. */
void act_cure(Window *window, Tab *tab, const Result *answer);

/* Selects the most dangerous place, zooms in on it and goes to its time. */
void act_show_place(Window *window);
void act_show_last(Window *window, Tab *tab, const Result *answer);

/* Takes the tool that sets the scale of the house. */
void act_set_scale(Window *window);
