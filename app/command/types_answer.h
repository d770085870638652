/* Types I, II and III as an answer of the program: told with progress, in words and as JSON. */
#pragma once

#include <jansson.h>

#include "options/options.h"
#include "study/types.h"

/* Tells the type of an experiment in a window of the parameters (name_count); `thorough` as in TypesTask. Shows how far
 * it is on a terminal. False: faults. */
bool types_answer_tell(Types *types, const Experiment *experiment, const Experiment *thorough, const char *const *names,
                       size_t name_count, const Options *options, Fault *fault);

/* Prints the advice; `each` is how long a run is, or NULL. */
void types_answer_print(const Types *types, const Experiment *experiment, const char *each);

/* The object "types". */
json_t *types_answer_json(const Types *types, const Experiment *experiment, const char *each);
