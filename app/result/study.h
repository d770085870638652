/* The facts of a study as rows, for `study`, its JSON and its tables. */
#pragma once

#include "result/result.h"
#include "study/study.h"
#include "study/summary.h"

/* Returns the state as people read it for this kind of experiment: "out", "not periodic", "undecided". */
const char *result_study_state(const Experiment *experiment, SummaryState state);

/* True if tables for people show the observable: it is not said by the state already, and any run has it. */
bool result_study_is_shown(const Study *study, size_t observable);

/* A record for each axis, and for each tolerance. */
ResultTable result_study_axes(const Study *study);
ResultTable result_study_spreads(const Study *study);

/* One record: how many runs there are, and with which answers. */
ResultTable result_study_counts(const Study *study);

/* A record for each range of equal answers along each axis in each pass. */
ResultTable result_study_ranges(const Study *study);

/* One record of the run with the least, or the greatest measure: its value, its parameters and its pass; none where no
 * run has the measure. */
ResultTable result_study_extreme(const Study *study, bool greatest);

/* A record for each value of the only axis that is chosen (steps), in each pass: the answer and the observables of its
 * run; or, of several runs, the share of regular ones and the distribution of the measure. */
ResultTable result_study_points(const Study *study, const bool *chosen);

/* One record: the share of regular runs, with its confidence interval; and a record for each observable, of a study
 * without an axis. */
ResultTable result_study_share(const Study *study);
ResultTable result_study_distributions(const Study *study);
