/* Writes the results of a study as tables for other programs: CSV (RFC 4180), headings `name [unit]`, an empty cell
 * for a missing number. Each file is written to a temporary file and renamed; the functions return 0, or errno. */
#pragma once

#include "study/study.h"

/* Writes one row per completed trial: varied values, pass, seed, observables, and the error if there is one. */
int study_csv_write_trials(const Study *study, const char *path);

/* Writes one row per value of the trials' series, in the order listed. */
int study_csv_write_series(const Study *study, const char *path);

/* Writes one row per point: the distributions of its runs. */
int study_csv_write_points(const Study *study, const char *path);
