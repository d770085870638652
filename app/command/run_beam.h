/* `run` of a beam. */
#pragma once

#include "options/options.h"

/* Runs the beam file of the command line, prints the answer, writes --out. Returns the exit code. */
int run_beam_file(const Options *options);
