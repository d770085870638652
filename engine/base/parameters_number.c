#include "base/parameters_number.h"

#include <math.h>

#include "base/choice.h"
#include "base/text.h"

enum { DIGITS_LEAST = 6 };

double parameters_number_get(const Parameter *row, const void *object) {
    const char *field = (const char *)object + row->offset;
    switch (row->kind) {
    case PARAMETER_NUMBER:
        return *(const double *)field;
    case PARAMETER_WHOLE:
    case PARAMETER_CHOICE:
        return *(const int *)field;
    case PARAMETER_FLAG:
        return *(const bool *)field;
    default:
        return NAN;
    }
}

json_t *parameters_number_json(const Parameter *row, double value) {
    if (row->kind == PARAMETER_FLAG)
        return json_boolean(value > 0);
    if (row->kind != PARAMETER_CHOICE)
        return json_number(value);
    size_t length;
    const char *word = choice_word(row->choices, (int)value, &length);
    return word ? json_stringn(word, length) : json_string("");
}

const char *parameters_number_text(const Parameter *row, double value, Arena *arena) {
    if (row->kind == PARAMETER_FLAG)
        return value > 0 ? "true" : "false";
    if (row->kind == PARAMETER_CHOICE) {
        size_t length;
        const char *word = choice_word(row->choices, (int)value, &length);
        return word ? text_in_arena(arena, "%.*s", (int)length, word) : "";
    }
    char number[TEXT_NUMBER];
    text_of_number(number, value, DIGITS_LEAST);
    return arena_text(arena, number);
}

bool parameters_number_same(const ParameterTable *table, const void *a, const void *b) {
    for (size_t i = 0; i < table->count; i++)
        if (parameters_number_get(&table->rows[i], a) != parameters_number_get(&table->rows[i], b))
            return false;
    return true;
}
