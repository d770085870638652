/* The dialogs that open a file: from pictures, or from folders. */
#pragma once

#include "window/window_state.h"

void dialog_gallery_show(Window *window);
void dialog_gallery_show_open(Window *window);

/* Releases the textures of the pictures. */
void dialog_gallery_clear(Window *window);
