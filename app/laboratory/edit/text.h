/* The texts of the panel: names, ids and notes of the selected item and of the house. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Returns the texts (count), valid until the next call. */
const EditText *edit_text_list(Editor *edit, size_t *count);

/* Sets the text with a name as in the list, as one step. False: the fault says why the value is invalid. */
bool edit_text_set(Editor *edit, const char *name, const char *value, Fault *fault);
