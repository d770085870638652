/* What the panel has of editing: what the tool places, the words of what is selected, the picture to trace over, and
 * what would let everybody out. */
#pragma once

#include "window/window_state.h"

void panel_edit_show(Window *window);

/* Names and ids of what is selected; the house's own name and note. */
void panel_edit_show_texts(Window *window);
void panel_edit_show_house(Window *window);
