/* The slider crank as what a study runs.
 *
 * Parameters are the rows of a crank file that are numbers, whole ones too. A trial of seed 0 begins as the file and
 * the parameters say. Of another seed, the ball begins anywhere in the middle nine tenths of its socket, and the
 * slider's velocity beside the ideal one is anything up to the clearance times the drive's angular speed.
 *
 * Carried on, a trial begins with what the state of the one before had beside its ideal mechanism, at angle 0; where
 * the coupler has another number of modes, as its seed says.
 *
 * Quick trials are told by how the ball returns (section.h) in run.cycles revolutions after run.transient_cycles;
 * thorough ones as `clearance run` tells them (response.h), confirmed by motions that are watched until they settle
 * (survival.h). */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/stop.h"
#include "crank/tree.h"
#include "study/experiment.h"

typedef enum CrankObservable {
    CRANK_REGULAR, /* 1 periodic, 0 chaotic or not periodic within the record, NAN undetermined */
    CRANK_PERIOD,
    CRANK_PEAK_MIN,
    CRANK_PEAK_MAX,
    CRANK_PEAK_MEAN,
    CRANK_TOUCHES,
    CRANK_CLEARANCE_RATIO, /* 1, c/r */
    CRANK_MOTION,          /* its class, by index into motion_class_names */
    CRANK_LYAPUNOV,        /* this and the following in thorough trials only */
    CRANK_LYAPUNOV_ERROR,
    CRANK_ZERO_ONE,
    CRANK_ROTATION,       /* 1, rotation number of a quasi-periodic motion */
    CRANK_HALF_LIFE,      /* 1, revolutions, of a transient */
    CRANK_ATTRACTOR_PEAK, /* N, largest force of the orbit that a motion is on or settles on */
    CRANK_OBSERVABLES,
} CrankObservable;

/* Opens the experiment of a crank file with `setting_count` settings and quick trials. Returns false after errors, with
 * nothing to close. */
bool crank_experiment_open(Experiment *experiment, const char *path, const char *const *settings, size_t setting_count,
                           Fault *fault);

/* Opens the experiment of a crank that is already read and must outlive it. */
void crank_experiment_of(Experiment *experiment, const Crank *crank);

/* Analyses each later trial fully, and watches `lanes` motions for `cycles` revolutions where it is not periodic; 0:
 * none. */
void crank_experiment_be_thorough(Experiment *experiment, size_t lanes, size_t cycles);

/* What a trial hands on to the next one: its last state in the scales of its cycle. */
typedef struct CrankCarry {
    size_t states; /* 0: nothing */
    double state[TREE_STATES_MOST];
} CrankCarry;

/* Runs `count` trials of one parameter one after another, the first continuing from `carry`: a carried pass in
 * pieces. */
void crank_experiment_run_on(const Experiment *experiment, const char *name, Trial *trials, size_t count,
                             CrankCarry *carry, const Stop *stop);

/* The window of types. */
enum { CRANK_EXPERIMENT_WINDOW = 4 };
extern const char *const crank_experiment_window[CRANK_EXPERIMENT_WINDOW];

void crank_experiment_close(Experiment *experiment);
