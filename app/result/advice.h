/* The meaning of a type for people who design a machine or furnish a house: two to five plain sentences. */
#pragma once

#include "base/text.h"
#include "study/types.h"

/* Adds the sentences, on two to four lines, the type on the first; `cycles` is the length of a run, or 0 to leave it
 * out. */
void advice_write(Text *text, const Types *types, const Experiment *experiment, int cycles);
