/* The dialogs over the window, one at a time: menus, card of keys, gallery, files, log. */
#pragma once

#include "window/window_state.h"

void dialogs_show(Window *window);
