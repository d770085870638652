/* The earthquake: each shake starts from the house as it stood before the last one, so shakes do not add up. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Makes an earthquake with the next seed, as one step. False: the fault says why no piece can fall. */
bool edit_shake_do(Editor *edit, Fault *fault);

/* Returns the shake whose outcome is the present draft, also after undoing; NULL: none. Good until the next shake. */
const EditShake *edit_shake_last(const Editor *edit);

/* Stands up what fell in that shake, as one step. */
bool edit_shake_stand_up(Editor *edit, Fault *fault);

/* Fixes a piece to the wall, as one step, after which the draft is the outcome of the same shake with that piece fixed.
 */
bool edit_shake_fix(Editor *edit, const char *id, Fault *fault);
void edit_shake_clear(Editor *edit);
