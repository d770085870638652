/* What is said of a house in the same words wherever it is said: on the terminal, in a report. */
#pragma once

#include "house/house.h"
#include "house/observation.h"

enum { HEADLINE_TEXT = 1024 /* room for a headline */ };

/* "Out in 18.4 s" or what stands against it. */
void headline_text(const House *house, const Observation *observation, char *text, size_t size);
