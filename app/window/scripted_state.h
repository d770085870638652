/* The window's state as a script asks for it: where its parts lie, what it shows, and what the laboratory says. */
#pragma once

#include <jansson.h>

#include "window/window_state.h"

/* All that can be asked for; new, json_decref it. */
json_t *scripted_state_of(Window *window);
