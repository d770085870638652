/* Actions on the selection: nudge, turn, topple, split, remove, copy, paste. Each action is one step. False: nothing
 * has changed, and the fault says why. */
#pragma once

#include "laboratory/edit/editor_state.h"

bool edit_action_nudge(Editor *edit, Vec2 by, Fault *fault);  /* by: m */
bool edit_action_turn(Editor *edit, double by, Fault *fault); /* by: degree */
bool edit_action_topple(Editor *edit, Fault *fault);
bool edit_action_can_topple(Editor *edit); /* True if what is selected falls to a side */
bool edit_action_split(Editor *edit, Fault *fault);
bool edit_action_remove(Editor *edit, Fault *fault);
bool edit_action_duplicate(Editor *edit, Fault *fault);

/* Returns the selection as text for a clipboard, NULL: nothing is selected. Release it with memory_free. */
char *edit_action_copy(const Editor *edit);
bool edit_action_paste(Editor *edit, const char *text, Fault *fault);
