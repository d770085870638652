/* Sets the scale of a whole house, so that the last measured distance has its real length: for plans of other programs
 * whose unit was wrong. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* The rows of the measuring tool. */
enum { ITEM_MEASURE, ITEM_SET_SCALE };

/* True if the tool in hand sets the scale: two points, then their real distance. */
bool edit_scale_in_hand(const Editor *edit);
void edit_scale_begin(Editor *edit, bool keys);

/* False: nothing was measured, or the house does not fit the limits of its numbers; the fault says which. */
bool edit_scale_set(Editor *edit, double length, Fault *fault);
