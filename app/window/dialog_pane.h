/* A sheet lies over the window and takes what is done until it is closed. */
#pragma once

#include "window/window_state.h"

/* Begins its pane; ui_pane_end ends it. */
void dialog_pane_begin(Window *window, Box box);

/* A box of that size in the middle of the page, or as much smaller as leaves `edge` of the page; all in design points.
 */
Box dialog_pane_centred(const Window *window, double width, double height, double edge);

/* Shows a dialog in place of any that is shown; closes what is shown, and forgets what was to follow it. */
void dialog_pane_show(Window *window, Dialog dialog);
void dialog_pane_close(Window *window);
