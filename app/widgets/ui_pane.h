/* Panes, their scrolling, and the flow of widgets in them. */
#pragma once

#include "widgets/ui_state.h"

/* Returns the next box in the flow, or that of ui_at; and its width. */
Box ui_pane_next(Ui *ui, double height);
double ui_pane_width(const Ui *ui);
UiPlace *ui_pane_find(const Ui *ui, UiId id);
void ui_pane_frame_begin(Ui *ui);
void ui_pane_frame_end(Ui *ui);
bool ui_pane_overflows(const UiPlace *place);
