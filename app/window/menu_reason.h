/* Which actions of the menus cannot be done now, and why. */
#pragma once

#include "window/window_state.h"

/* Returns a sentence that says why an action cannot be done now; NULL: it can. The sentence lives as long as the frame
 * or longer. */
const char *menu_reason_of(Window *window, Action action);

/* Returns why a lesson does not let the class change anything yet; NULL: it does, or the action changes nothing. */
const char *menu_reason_to_guess(Window *window, Action action);
