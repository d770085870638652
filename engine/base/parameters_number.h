/* Parameters that are one number, a switch or a word to choose: as a number, for sliders, sweeps and comparisons. */
#pragma once

#include "base/parameters.h"

/* The value in the row's unit; of a choice the place of its word, of a flag 0 or 1. NAN: it is nothing of the kind. */
double parameters_number_get(const Parameter *row, const void *object);

/* A value as a file has it; "": a place beyond the words. New, json_decref it. */
json_t *parameters_number_json(const Parameter *row, double value);

/* A value as `--set` takes it: the fewest digits that are read as the same number, or a word; as long as the arena
 * lives. */
const char *parameters_number_text(const Parameter *row, double value, Arena *arena);
