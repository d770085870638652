/* Lines for the person at the window: above the strip of keys, and in the log. */
#pragma once

#include "window/window_state.h"

/* Posts a line that disappears by itself after a while. */
void notice_post(Window *window, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Adds a line to the log alone, of what the strip counts while it goes on. */
void notice_log(Window *window, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Returns the message that is shown, the oldest fault first, and how many faults there are; NULL: none. */
const Message *notice_shown(Window *window, size_t *faults);

/* Dismisses it; true if it was a fault, which stays until then. */
bool notice_dismiss(Window *window);

/* Says what was edited, with a button that undoes it; called once a frame. */
void notice_edit(Window *window);

/* Has a search for fixes drawn again when it has got farther; called once a frame. */
void notice_search(Window *window);

/* Posts the lines of a fault, if there are any, which stay until they are dismissed, and releases it; `time`: the
 * simulated moment they are about, s, or NAN. */
void notice_fault(Window *window, Fault *fault, double time);

/* Returns the folder that pictures and exports go into, to be released by memory_free. NULL: a fault was posted. */
char *notice_folder(Window *window);
