/* `study BEAM --paper`: compares the claims and figures of the paper with our results. */
#pragma once

#include "options/options.h"

/* Computes the figures, prints the claims, writes paper.html, paper.pdf, summary.json and a picture of each figure to
 * --out. Returns the exit code. */
int paper_answer(const Options *options);
