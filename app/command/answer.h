/* Answers as JSON (the contract), those about a house, and the latter in words and tables, for people to read. */
#pragma once

#include <jansson.h>

#include "base/text.h"
#include "house/house.h"
#include "house/observation.h"

/* {"kind":"house", ...}. An interrupted run leaves "completed" out unless all people are out. New; json_decref it. */
json_t *answer_house(const House *house, const Observation *observation);

/* Adds "interrupted": true to an answer that is not complete, or whose pictures and films are not. Scripts tell an
 * interruption from a no by it, for both have one exit code. */
void answer_mark_interrupted(json_t *answer, bool interrupted);

/* Prints one JSON object on standard output. */
void answer_print(json_t *answer);

/* Writes it as summary.json is written, beside and renamed. 0, or errno. */
int answer_write(const json_t *answer, const char *path);

/* Adds the answer, followed by `more` unless that is "", people (of many the sums, and some of those who are not out),
 * routes and tight places. */
void answer_text_add(Text *text, const House *house, const Observation *observation, const char *more);

/* Prints the same on standard output. */
void answer_text_print(const House *house, const Observation *observation, const char *more);
