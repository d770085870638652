/* The window's state for scripts: the places of its parts, what it shows, and the laboratory's results. */
#pragma once

#include <jansson.h>

#include "window/window_state.h"

/* Returns the whole state, to be released by json_decref. */
json_t *scripted_state_of(Window *window);

/* Returns the texts of the widgets as they were painted last: each with its box and its clip, pixels. */
json_t *scripted_state_texts(const Window *window);
