/* `study --follow` of a beam. */
#pragma once

#include "options/options.h"

/* `study BEAM --follow NAME=FROM:TO`: follows the orbit of the file through a range of one number, prints the table,
 * writes follow.csv and summary.json to --out. Returns the exit code. */
int follow_beam_file(const Options *options);
