/* Answers as JSON (the contract); those about a house. */
#pragma once

#include <jansson.h>

#include "house/house.h"
#include "house/observation.h"

/* {"kind":"house", ...}. New; json_decref it. */
json_t *answer_house(const House *house, const Observation *observation);

/* Prints one JSON object on standard output. */
void answer_print(json_t *answer);

/* Writes it as summary.json is written, beside and renamed. 0, or errno. */
int answer_write(const json_t *answer, const char *path);
