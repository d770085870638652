/* The results of a study as tables for other programs: CSV (RFC 4180), a header `name [unit]`, an empty cell where
 * there is no number. Files are written beside and renamed; 0, or errno. */
#pragma once

#include "study/study.h"

/* A row a trial that is done: the varied values, the pass, the seed, the observables, the fault if there is one. */
int record_write_trials(const Study *study, const char *path);

/* A row a number of the trials' series, in the order in which it was listed. */
int record_write_series(const Study *study, const char *path);

/* A row a point: its runs as distributions. */
int record_write_points(const Study *study, const char *path);
