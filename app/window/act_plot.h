/* What actions do to a plot that has the focus, and how what is seen is handed on. */
#pragma once

#include "window/window_state.h"

/* True: it was one of these. */
bool act_plot_do(Window *window, Action action, int mods);

/* Sets the number that a plot's cursor stands for to a value of x. */
void act_plot_use(Window *window, const PlotPane *pane, double x);
