/* The number fields of a gesture, which can be typed while it lasts. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Sets the names and units of the fields (count); all values are untyped. The texts must outlive the gesture. */
void edit_field_list(Editor *edit, const char *const *names, const char *const *units, size_t count);

/* True if the field is typed; then `*value` is the typed value, in the field's unit. */
bool edit_field_typed(const Editor *edit, size_t field, double *value);

/* Sets the value of a field that is not typed. */
void edit_field_show(Editor *edit, size_t field, double value);

/* True if any field is typed. */
bool edit_field_any(const Editor *edit);

/* Keys, as in editor.h; false: the key is not used. */
bool edit_field_type(Editor *edit, const char *characters);
bool edit_field_back(Editor *edit);
bool edit_field_tab(Editor *edit, int step);

/* True if a number can begin with these characters. */
bool edit_field_begins(const char *characters);
