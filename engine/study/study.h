/* Runs one experiment over a grid: a sweep of one parameter or a map of two, each point once or with many seeds,
 * from its own initial state (reset) or continued from its neighbour, upwards or downwards. The results do not
 * depend on the number of jobs, nor on interruptions. */
#pragma once

#include "base/fault.h"
#include "base/file_memory.h"
#include "base/stop.h"
#include "study/experiment.h"

enum {
    STUDY_AXES_MOST = 2,
    STUDY_SPREADS_MOST = 8,
    STUDY_NAMES_MOST = STUDY_AXES_MOST + STUDY_SPREADS_MOST,
    STUDY_STEPS_MOST = 100000,
    STUDY_RUNS_MOST = 100000000,
    STUDY_TRIALS_MOST = 100000000,
    STUDY_IN_MEMORY = 2000000, /* trials; those of a larger study lie in a file */
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

/* The part of a study that one machine runs: the `number`-th of `count` parts. It has every `count`-th trial, and of a
 * carried pass every `count`-th chain along axis 0, since a trial of such a chain needs those before it. Cost changes
 * smoothly along an axis, so that such parts take nearly the same time. */
typedef struct StudyShard {
    size_t number; /* from 1 */
    size_t count;  /* 0: the whole study */
} StudyShard;

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
    size_t runs;      /* of each point: run r has the seed `seed` + r */
    uint64_t seed;    /* seed of the first run; with seed 0 all deviations are 0 and the initial state is nominal */
    StudyShard shard; /* the trials that have room and are run */

    const char *names[STUDY_NAMES_MOST]; /* (name_count) names of the trials' `at`: the axes, then the other spreads */
    size_t name_count;
    Trial *trials;      /* (study_room) those of the shard, in their order */
    size_t trial_count; /* of the whole study */
    double *values;     /* memory of the trials' `at` and `observed` */
    FileMemory *large;  /* where both lie, with the series and faults, of a large study; NULL: in the heap */
    const char *folder; /* of the file of a large study */
    bool full;          /* there was no room for a result, which is lost */
} Study;

typedef struct StudyOptions {
    int jobs; /* threads */
    const Stop *stop;
    void (*progress)(void *context, size_t done,
                     size_t all); /* counts of the shard's trials; called by one thread at a time; NULL: none */
    void *context;

    /* Receives the trials (`count` indices) just completed; called by one thread at a time; NULL: none. */
    void (*keep)(void *keeper, const Study *study, const size_t *done, size_t count);
    void *keeper;
} StudyOptions;

/* "reset", "up", "down" */
const char *study_pass_name(StudyPass pass);

/* Returns the i-th value of the axis. */
double study_value(const StudyAxis *axis, size_t i);

/* True if the study can run; otherwise errors name the invalid axes, spreads, passes or runs. */
bool study_check(const Study *study, Fault *fault);

/* Returns the number of trials of a checked study. */
size_t study_size(const Study *study);

/* Creates the trials of the shard, none of them done, of a checked study. study_clear releases them. */
void study_begin(Study *study);
void study_clear(Study *study);

/* The same with all results in a file without a name, of which a bounded part is in memory at a time. Returns false,
 * with an error, where `folder` has no room for them. */
bool study_begin_in(Study *study, const char *folder, Fault *fault);

/* Gives a trial its result, with the series and fault of `result`, which are the study's from then on. Returns false,
 * and the study is `full`, where there is no room. */
bool study_take(Study *study, size_t trial, Trial *result);

/* Makes all trials undone. */
void study_forget(Study *study);

/* Runs the trials of the shard that are not done; an interruption, or a full study, keeps completed ones. A carried
 * pass restarts at its first point along axis 0: intermediate states are not stored. */
void study_run(Study *study, const StudyOptions *options);

/* Returns the digest of all inputs; `given` is the digest of the experiment's file, settings and program version. */
uint64_t study_digest(const Study *study, uint64_t given);

/* Returns the number of completed trials of the shard. */
size_t study_done(const Study *study);

/* Returns the number of trials of the shard, which have room. */
size_t study_room(const Study *study);

/* Returns which of `count` shards, from 1, has the trial. */
size_t study_shard_of(const Study *study, size_t count, size_t trial);

/* True if the study's shard has the trial. */
bool study_has(const Study *study, size_t trial);

/* Returns the place of a trial that the shard has among `trials`. */
size_t study_place(const Study *study, size_t trial);

/* Returns the number of values of an axis; 1 for an absent axis. */
static inline size_t study_steps(const Study *study, size_t axis) {
    return axis < study->axis_count ? study->axes[axis].steps : 1;
}

static inline size_t study_index(const Study *study, size_t pass, size_t run, size_t i1, size_t i0) {
    return ((pass * study->runs + run) * study_steps(study, 1) + i1) * study_steps(study, 0) + i0;
}

/* A trial that the shard has. */
static inline const Trial *study_nth(const Study *study, size_t trial) {
    if (study->large)
        file_memory_touch(study->large);
    return &study->trials[study->shard.count ? study_place(study, trial) : trial];
}

static inline const Trial *study_trial(const Study *study, size_t pass, size_t run, size_t i1, size_t i0) {
    return study_nth(study, study_index(study, pass, run, i1, i0));
}

/* Returns the index into study->passes of a trial. */
static inline size_t study_pass_of(const Study *study, size_t trial) {
    return trial / (study->runs * study_steps(study, 1) * study_steps(study, 0));
}
