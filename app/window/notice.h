/* Lines for the person at the window: above the strip of keys, and in the log. */
#pragma once

#include "window/window_state.h"

/* Posts a line that disappears by itself after a while. */
void notice_post(Window *window, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Posts the lines of a fault, if there are any, which stay until they are dismissed, and releases it; `time`: the
 * simulated moment they are about, s, or NAN. */
void notice_fault(Window *window, Fault *fault, double time);

/* Returns the folder that pictures and exports go into, to be released by memory_free. NULL: a fault was posted. */
char *notice_folder(Window *window);
