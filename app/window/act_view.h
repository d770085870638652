/* What actions do to the eye: where it looks, from where, and which layers it sees. */
#pragma once

#include "window/window_state.h"

/* True: it was one of these; `key` says which layer. */
bool act_view_do(Window *window, Tab *tab, Action action, int32_t key);
