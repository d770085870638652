/* Many runs of one experiment over a grid: a sweep of one parameter, a map of two, each point once or with many seeds,
 * from rest (reset) or carried on from the neighbour, upwards or downwards. The same results for any number of jobs,
 * and for a study that was stopped and went on. */
#pragma once

#include "base/fault.h"
#include "study/experiment.h"

enum {
    STUDY_AXES_MOST = 2,
    STUDY_SPREADS_MOST = 8,
    STUDY_NAMES_MOST = STUDY_AXES_MOST + STUDY_SPREADS_MOST,
    STUDY_STEPS_MOST = 100000,
    STUDY_RUNS_MOST = 100000,
    STUDY_TRIALS_MOST = 2000000, /* some GB with a hundred peaks each */
};

typedef struct StudyAxis {
    const char *name; /* of a parameter of the experiment */
    double from, to;
    size_t steps; /* values, both ends among them */
} StudyAxis;

/* A tolerance: in each run the parameter is off by a normal deviate, drawn from the run's seed, the same at every point
 * of the grid. */
typedef struct StudySpread {
    const char *name; /* of a parameter, that of an axis too */
    double share;     /* 1, the standard deviation over the value */
} StudySpread;

typedef enum StudyPass { STUDY_RESET, STUDY_UP, STUDY_DOWN, STUDY_PASSES } StudyPass;

/* What is asked, and the results so far. A trial's index is
 * ((pass_index * runs + run) * steps of axis 1 + i1) * steps of axis 0 + i0. */
typedef struct Study {
    const Experiment *experiment;
    StudyAxis axes[STUDY_AXES_MOST];
    size_t axis_count; /* 0: only runs */
    StudySpread spreads[STUDY_SPREADS_MOST];
    size_t spread_count;
    StudyPass passes[STUDY_PASSES];
    size_t pass_count;
    size_t runs;   /* of each point: run r has the seed `seed` + r */
    uint64_t seed; /* of the first; with seed 0 nothing is off and the start is the nominal one */

    const char *names[STUDY_NAMES_MOST]; /* (name_count) of the trials' `at`: the axes', then the spreads' other ones */
    size_t name_count;
    Trial *trials; /* (trial_count) */
    size_t trial_count;
    double *values; /* room of the trials' `at` and `observed` */
} Study;

typedef struct StudyOptions {
    int jobs; /* threads */
    const volatile sig_atomic_t *stop;
    void (*progress)(void *context, size_t done, size_t all); /* trials; from one thread at a time; NULL: none */
    void *context;

    /* Is given the trials (count indices) that have just been done; from one thread at a time; NULL: none. */
    void (*keep)(void *keeper, const Study *study, const size_t *done, size_t count);
    void *keeper;
} StudyOptions;

/* "reset", "up", "down" */
const char *study_pass_name(StudyPass pass);

/* The axis' i-th value. */
double study_value(const StudyAxis *axis, size_t i);

/* Can it be done? False: faults say what of axes, spreads, passes and runs cannot. */
bool study_check(const Study *study, Fault *fault);

/* Makes the trials, none of them done, of a study that has been checked. study_clear releases them. */
void study_begin(Study *study);
void study_clear(Study *study);

/* Does the trials that are not done; what is complete stays when it is stopped. A carried pass along axis 0 goes from
 * its beginning, what was done of it included, for nobody knows any more where it stood. */
void study_run(Study *study, const StudyOptions *options);

/* Of everything that determines the results; `given` of what the experiment was made of: file, settings, program. */
uint64_t study_digest(const Study *study, uint64_t given);

/* How many trials are done. */
size_t study_done(const Study *study);

/* The number of values that an axis has; 1 for one that the study has not. */
static inline size_t study_steps(const Study *study, size_t axis) {
    return axis < study->axis_count ? study->axes[axis].steps : 1;
}

static inline size_t study_index(const Study *study, size_t pass, size_t run, size_t i1, size_t i0) {
    return ((pass * study->runs + run) * study_steps(study, 1) + i1) * study_steps(study, 0) + i0;
}

static inline const Trial *study_trial(const Study *study, size_t pass, size_t run, size_t i1, size_t i0) {
    return &study->trials[study_index(study, pass, run, i1, i0)];
}

/* The index into study->passes that a trial is of. */
static inline size_t study_pass_of(const Study *study, size_t trial) {
    return trial / (study->runs * study_steps(study, 1) * study_steps(study, 0));
}
