/* The dialogs that open a file: from pictures, or from folders. */
#pragma once

#include "window/window_state.h"

void dialog_gallery_show(Window *window);
void dialog_gallery_show_open(Window *window);

/* True if the open dialog lists an entry, by what is typed. */
bool dialog_gallery_lists(const Window *window, const FolderEntry *entry);

/* On the start page, characters find a card by its name, Backspace and Escape take them back, and 1, 2, 3 open what is
 * to be tried. Return true if the key or text was used. */
bool dialog_gallery_key(Window *window, const SdlWindowEvent *event);
bool dialog_gallery_type(Window *window, const char *text);

/* Releases the textures of the pictures. */
void dialog_gallery_clear(Window *window);
