/* Numbers of sliders as text. */
#pragma once

#include "widgets/ui_state.h"

enum { UI_REASON = 256 /* bytes of the reason why a number is invalid */ };

/* Prints a value with its unit. */
void ui_number_print(const UiSlider *slider, double value, char *text, size_t size);

/* True if a typed text is not a valid number for the slider; `reason` then names the range and the error. */
bool ui_number_is_wrong(const UiSlider *slider, const char *text, double *value, char reason[UI_REASON]);
