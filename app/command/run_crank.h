/* `run` of a slider crank. */
#pragma once

#include "options/options.h"

/* Runs the crank file of the command line, prints the answer, writes --out. Returns the exit code. */
int run_crank_file(const Options *options);
