/* `run` of a beam. */
#pragma once

#include "command/command.h"

/* Runs the beam file of the command line, prints the answer, writes --out. Returns the exit code. */
int run_beam_file(const Options *options);
