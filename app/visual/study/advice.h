/* What a type means for somebody who designs a machine or furnishes a house: two to five plain sentences. */
#pragma once

#include "base/text.h"
#include "study/types.h"

/* Adds the sentences, each on a line; `each` is how long a run is, "400 cycles", or NULL. */
void advice_write(Text *text, const Types *types, const Experiment *experiment, const char *each);
