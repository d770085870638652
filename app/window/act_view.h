/* Carries out the actions on the camera and the layers. */
#pragma once

#include "window/window_state.h"

/* Returns false if the action is another one; `key` selects the layer. */
bool act_view_do(Window *window, Tab *tab, Action action, int32_t key);
