/* The name of what is selected, next to it in the view. */
#pragma once

#include "window/window_state.h"

/* Places and shows it, unless the picture has that name already; `window->selected_name` says where it stands. */
void selected_name_show(Window *window);
