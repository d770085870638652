/* Many runs of one experiment over a grid: a sweep of one parameter, a map of two, each point once or with many seeds,
 * from rest (reset) or carried on from the neighbour, upwards or downwards. The same results for any number of jobs,
 * and for a study that was stopped and went on. */
#pragma once

#include "base/fault.h"
#include "study/experiment.h"

enum { STUDY_AXES_MOST = 2 };

typedef struct StudyAxis {
    const char *name; /* of a parameter of the experiment */
    double from, to;
    size_t steps; /* values, both ends among them */
} StudyAxis;

typedef enum StudyPass { STUDY_RESET, STUDY_UP, STUDY_DOWN, STUDY_PASSES } StudyPass;

/* What is asked, and the results so far. A trial's index is
 * ((pass_index * runs + run) * steps of axis 1 + i1) * steps of axis 0 + i0. */
typedef struct Study {
    const Experiment *experiment;
    StudyAxis axes[STUDY_AXES_MOST];
    size_t axis_count; /* 0: only runs */
    StudyPass passes[STUDY_PASSES];
    size_t pass_count;
    size_t runs;   /* of each point: seeds 0, or seed, seed + 1 ... when there are several */
    uint64_t seed; /* of the first */

    Trial *trials; /* (trial_count) */
    size_t trial_count;
    double *values; /* room of the trials' `at` and `observed` */
} Study;

/* The axis' i-th value. */
double study_value(const StudyAxis *axis, size_t i);

static inline const Trial *study_trial(const Study *study, size_t pass, size_t run, size_t i1, size_t i0) {
    size_t steps0 = study->axis_count > 0 ? study->axes[0].steps : 1;
    size_t steps1 = study->axis_count > 1 ? study->axes[1].steps : 1;
    return &study->trials[((pass * study->runs + run) * steps1 + i1) * steps0 + i0];
}
