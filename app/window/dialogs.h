/* What lies over the window, one at a time: menus, the card of keys, gallery, dialogs, the log. */
#pragma once

#include "window/window_state.h"

void dialogs_show(Window *window);
