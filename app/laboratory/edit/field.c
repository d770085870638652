#include "laboratory/edit/field.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"

void edit_field_list(Editor *edit, const char *const *names, const char *const *units, size_t count) {
    for (size_t i = 0; i < count; i++)
        edit->fields[i] = (EditField){.name = names[i], .unit = units[i]};
    edit->field_count = count;
    edit->field = 0;
    *edit->typed = *edit->typed_error = 0;
}

bool edit_field_typed(const Editor *edit, size_t field, double *value) {
    const EditField *is = &edit->fields[field];
    if (field >= edit->field_count || !is->typed)
        return false;
    *value = is->value;
    return true;
}

void edit_field_show(Editor *edit, size_t field, double value) {
    if (field < edit->field_count && !edit->fields[field].typed)
        edit->fields[field].value = value;
}

bool edit_field_any(const Editor *edit) {
    for (size_t i = 0; i < edit->field_count; i++)
        if (edit->fields[i].typed)
            return true;
    return false;
}

bool edit_field_begins(const char *characters) {
    return (*characters >= '0' && *characters <= '9') || (*characters && strchr("-.,+", *characters));
}

/* True if the characters may continue a number: letters of units, signs and, beyond ASCII, the degree and minus
 * signs. */
static bool may_continue(const char *characters) {
    for (; *characters; characters++)
        if (!strchr("0123456789-+., '\"cmkftinrdeg", *characters) && (unsigned char)*characters < 0x80)
            return false;
    return true;
}

/* Reads the typed text; the last value stays while the text is not a number. */
static void read_typed(Editor *edit) {
    EditField *field = &edit->fields[edit->field];
    char reason[QUANTITY_REASON];
    double value;
    *edit->typed_error = 0;
    field->typed = *edit->typed != 0;
    field->moved = false;
    if (!field->typed)
        return;
    if (!quantity_read(edit->typed, strcmp(field->unit, "degree") == 0 ? "deg" : field->unit, &value, reason)) {
        snprintf(edit->typed_error, sizeof edit->typed_error, "%s", reason);
        return;
    }
    if (fabs(value) > PARAMETER_FARTHEST)
        snprintf(edit->typed_error, sizeof edit->typed_error, "%g %s is beyond the plan, at most %g %s", value,
                 field->unit, PARAMETER_FARTHEST, field->unit);
    else
        field->value = value;
}

bool edit_field_type(Editor *edit, const char *characters) {
    size_t used = strlen(edit->typed);
    bool fits = *edit->typed ? may_continue(characters) : edit_field_begins(characters) && may_continue(characters);
    if (!edit->gesture || !edit->field_count || !fits)
        return false;
    snprintf(edit->typed + used, sizeof edit->typed - used, "%s", characters);
    read_typed(edit);
    return true;
}

bool edit_field_back(Editor *edit) {
    size_t used = strlen(edit->typed);
    if (!used)
        return false;
    while (used > 1 && ((unsigned char)edit->typed[used - 1] & 0xC0) == 0x80)
        used--; /* continuation bytes of a UTF-8 character */
    edit->typed[used - 1] = 0;
    read_typed(edit);
    return true;
}

bool edit_field_tab(Editor *edit, int step) {
    if (!edit->gesture || !edit->field_count)
        return false;
    if (*edit->typed_error)
        return true; /* not before the text is a number or has been removed */
    size_t count = edit->field_count;
    edit->field = (edit->field + count + (size_t)(step < 0 ? count - 1 : 1)) % count;
    *edit->typed = 0;
    return true;
}
