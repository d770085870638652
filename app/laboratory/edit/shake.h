/* The earthquake: each shake starts from the house as it stood before the last one, so shakes do not add up. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Makes an earthquake with the next seed, as one step. False: the fault says why no piece can fall. */
bool edit_shake_do(Editor *edit, Fault *fault);
void edit_shake_clear(Editor *edit);
