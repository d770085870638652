/* The meaning of a type for people who design a machine or furnish a house: two to five plain sentences. */
#pragma once

#include "base/text.h"
#include "study/types.h"

/* Adds the sentences, each on a line; `each` is the length of a run, "400 cycles", or NULL. */
void advice_write(Text *text, const Types *types, const Experiment *experiment, const char *each);
