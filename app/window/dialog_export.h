/* The dialogs that export pictures, plots, data, films and reports, and that save a copy of the file. */
#pragma once

#include "window/window_state.h"

void dialog_export_show(Window *window);
void dialog_export_show_save(Window *window);
