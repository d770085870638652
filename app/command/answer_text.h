/* The answer about a house in words and tables, for people to read. */
#pragma once

#include "base/text.h"
#include "house/house.h"
#include "house/observation.h"

/* Adds answer, people (of many the sums, and some of those who are not out), routes and dangerous points. */
void answer_text_add(Text *text, const House *house, const Observation *observation);

/* Prints the same on standard output. */
void answer_text_print(const House *house, const Observation *observation);
