/* Carries out the actions on the focused plot, and those that write pictures and frames. */
#pragma once

#include "window/window_state.h"

/* Returns false if the action is another one. */
bool act_plot_do(Window *window, Action action, int mods);

/* Sets the parameters of a plot's cursors to values of x and y; NAN: not that one. */
void act_plot_use(Window *window, const PlotPane *pane, Vec2 value);

/* Shows or hides the plots. */
void act_plot_toggle(Window *window);

/* Says why plots that were asked for are not shown in this frame. */
void act_plot_explain(Window *window);
