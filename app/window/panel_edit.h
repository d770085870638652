/* The editing part of the panel: the catalogue of the tool, the texts of the selection, the picture to trace, and the
 * proposals that let all people out. */
#pragma once

#include "window/window_state.h"

void panel_edit_show(Window *window);

/* Shows a heading of the selection; one that stands above already is not repeated. */
void panel_edit_heading(Window *window, const char *text);

/* Shows why a person cannot leave, and offers the smallest change. */
void panel_edit_show_way_out(Window *window);

/* Show the names and ids of the selection; the house's own name and note. */
void panel_edit_show_texts(Window *window);
void panel_edit_show_house(Window *window);
