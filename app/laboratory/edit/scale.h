/* Sets the scale of a whole house, so that the last measured distance has its real length: for plans of other programs
 * whose unit was wrong. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* False: nothing was measured, or the house does not fit the limits of its numbers; the fault says which. */
bool edit_scale_set(Editor *edit, double length, Fault *fault);
