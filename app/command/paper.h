/* `study BEAM --paper`: the paper's claims and figures beside what the beam does. */
#pragma once

#include "options/options.h"

/* Makes them, prints the claims, writes paper.html, paper.pdf, summary.json and a picture of each figure to --out.
 * Returns the exit code. */
int paper_answer(const Options *options);
