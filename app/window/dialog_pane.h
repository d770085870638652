/* A dialog lies over the window and receives all input until it is closed. */
#pragma once

#include "window/window_state.h"

/* Begins the dialog's pane, which ui_pane_end ends. */
void dialog_pane_begin(Window *window, Box box);

/* Returns a box of that size in the middle of the page, smaller if less than `edge` of the page would be left; design
 * points. */
Box dialog_pane_centred(const Window *window, double width, double height, double edge);

/* Shows a dialog in place of the current one; closes the current one and cancels what was to follow it. */
void dialog_pane_show(Window *window, Dialog dialog);
void dialog_pane_close(Window *window);

/* Returns a time, s since 1970, as "14:02", with its date if that is not today; in the frame's arena. */
const char *dialog_pane_when(Window *window, int64_t when);
