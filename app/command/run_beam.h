/* `run` of a beam. */
#pragma once

#include "options/options.h"

/* Runs the beam file of the command line, prints the answer, writes --out. Returns the exit code. */
int run_beam_file(const Options *options);

/* `study BEAM --follow NAME=FROM:TO`: follows the orbit of the file through a range of one number, prints the table,
 * writes follow.csv and summary.json to --out. Returns the exit code. */
int run_beam_follow(const Options *options);
