/* Choosing what to open: from pictures, or from folders. */
#pragma once

#include "window/window_state.h"

void dialog_gallery_show(Window *window);
void dialog_gallery_show_open(Window *window);

/* Releases the pictures' textures. */
void dialog_gallery_clear(Window *window);
