/* The stop that has the focus, and the effect of keys. */
#pragma once

#include "widgets/ui_state.h"

void ui_focus_frame_begin(Ui *ui);
void ui_focus_frame_end(Ui *ui);
