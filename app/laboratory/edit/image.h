/* The picture to trace over (trace image): two points a known length apart set its scale, two points on a level line
 * set its angle. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Begins to scale or level the trace image. */
void edit_image_begin(Editor *edit, bool keys);

/* Sets the trace image; path NULL or "": none. False: the fault says why the file cannot be used. */
bool edit_image_set(Editor *edit, const char *path, Fault *fault);

/* Sets the opacity, 0 to 1. */
void edit_image_fade(Editor *edit, double opacity);

/* Returns the trace image; its path is valid until the plan changes. */
TraceImage edit_image_get(Editor *edit);

/* Returns one line that says why the trace image differs from the original; NULL: it is unchanged, or there is none. */
const char *edit_image_error(Editor *edit);
