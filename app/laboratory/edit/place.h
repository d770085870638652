/* Places one item at the pointer: a piece of furniture, a person, or a door. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Begins to place the chosen item of the present tool. */
void edit_place_begin(Editor *edit, bool keys);

/* As editor_cure. */
void edit_place_cure(Editor *edit);
