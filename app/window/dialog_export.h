/* Handing on what is shown: pictures, plots, data, films, reports, and a copy of the file with its changed numbers. */
#pragma once

#include "window/window_state.h"

void dialog_export_show(Window *window);
void dialog_export_show_save(Window *window);
