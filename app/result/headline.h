/* The headline of a run, the same on the terminal and in a report. */
#pragma once

#include "house/house.h"
#include "house/observation.h"

enum { HEADLINE_TEXT = 1024 /* room for a headline */ };

/* Prints "Out in 18.4 s", or why people are not out. */
void headline_text(const House *house, const Observation *observation, char *text, size_t size);
