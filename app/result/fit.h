/* A fit as rows: the parameters before and after, the measured values beside the simulated ones, and what the data do
 * not tell, in words. */
#pragma once

#include "result/result.h"
#include "study/fit.h"

/* Returns "2 of 4 parameters are told by 20 values; the others keep what was known before". */
const char *result_fit_sentence(const Fit *fit, Arena *arena);

/* Returns the remarks (count): correlations, several minima, leaving out, signs. They live as long as the arena. */
const char **result_fit_remarks(const Fit *fit, size_t *count, Arena *arena);

/* A record for each parameter; `experiment` knows their units. */
ResultTable result_fit_unknowns(const Fit *fit, const Experiment *experiment);

/* A record for each measured value. */
ResultTable result_fit_rows(const Fit *fit);

/* A record of the whole: sums, runs, errors. */
ResultTable result_fit_whole(const Fit *fit);
