/* Carries out the actions on the focused plot, and those that write pictures and frames. */
#pragma once

#include "window/window_state.h"

/* Returns false if the action is another one. */
bool act_plot_do(Window *window, Action action, int mods);

/* Sets the parameter of a plot's cursor to a value of x. */
void act_plot_use(Window *window, const PlotPane *pane, double x);
