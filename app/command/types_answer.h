/* Types I, II and III as an answer of the program: classified with progress, as text and as JSON. */
#pragma once

#include <jansson.h>

#include "options/options.h"
#include "study/types.h"

/* Classifies an experiment in a window of the parameters (name_count); `thorough` as in TypesTask. Shows how far
 * it is on a terminal. False: faults. */
bool types_answer_classify(Types *types, const Experiment *experiment, const Experiment *thorough,
                           const char *const *names, size_t name_count, const Options *options, Fault *fault);

/* Prints the advice; `cycles` is the length of a run, or 0 to leave it out. */
void types_answer_print(const Types *types, const Experiment *experiment, int cycles);

/* Prints a table of the parameters: how sensitive the answer is to each, and where it changes on either side. */
void types_answer_print_parameters(const Types *types, const Experiment *experiment);

/* The object "types". */
json_t *types_answer_json(const Types *types, const Experiment *experiment, int cycles);
