/* Parameters that are one number, a switch or a choice, represented as a number for sliders, sweeps and comparisons. */
#pragma once

#include "base/parameters.h"

/* Returns the value in the row's unit: the index of a choice's word, 0 or 1 for a flag, NAN for any other kind. */
double parameters_number_get(const Parameter *row, const void *object);

/* True if all numbers of two objects are equal. */
bool parameters_number_same(const ParameterTable *table, const void *a, const void *b);

/* Returns a value in the form of a file; "" for an index beyond the words. New, json_decref it. */
json_t *parameters_number_json(const Parameter *row, double value);

/* Returns a value in the form of `--set`: the fewest digits that are read as the same number, or a word. The text lives
 * as long as the arena. */
const char *parameters_number_text(const Parameter *row, double value, Arena *arena);
