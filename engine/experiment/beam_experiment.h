/* The beam in its clearance as what a study runs.
 *
 * Parameters are the rows of a beam file that are numbers, whole ones too, and the start, at phase 0 of the drive:
 *
 *     start.deflection   m, of the tip: the beam is bent as by a static force at its tip
 *     start.velocity     m/s, of the tip: every point moves in proportion to that same shape
 *
 * A trial of seed 0 begins as these say, at rest where they do not. Of another seed, what they do not say is random:
 * the deflection uniform within the clearance, the velocity uniform up to +-omega times the amplitude that the tip has
 * without the joint.
 *
 * Of the seed BEAM_EXPERIMENT_FREE, it begins with the steady response without the joint.
 *
 * Carried on, a trial begins with the state that the one before ended with, at the drive's phase 0. Where the beam is
 * another one, each natural mode keeps its share of the tip's deflection and velocity; modes that there were not rest.
 * After numbers that were lost, it begins as its seed says.
 *
 * Quick trials are told by how the tip returns (section.h) in run.cycles cycles after run.transient_cycles; thorough
 * ones as `clearance run` tells them (response.h), confirmed by motions that are watched until they settle
 * (survival.h). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/stop.h"
#include "beam/beam.h"
#include "experiment/beam_carry.h"
#include "study/experiment.h"

typedef enum BeamObservable {
    BEAM_REGULAR, /* 1 periodic, 0 chaotic or not periodic within the record, NAN undetermined */
    BEAM_PERIOD,
    BEAM_PEAK_MIN,
    BEAM_PEAK_MAX,
    BEAM_PEAK_MEAN,
    BEAM_TOUCHES,
    BEAM_CLEARANCE_RATIO, /* 1, g/a; a is the static deflection of the tip under the drive's amplitude without the joint
                           */
    BEAM_MOTION,          /* its class, by index into motion_class_names */
    BEAM_LYAPUNOV,        /* this and the following in thorough trials only */
    BEAM_LYAPUNOV_ERROR,
    BEAM_ZERO_ONE,
    BEAM_ROTATION,       /* 1, rotation number of a quasi-periodic motion */
    BEAM_HALF_LIFE,      /* 1, cycles, of a transient */
    BEAM_ATTRACTOR_PEAK, /* N, largest force of the orbit that a motion is on or settles on */
    BEAM_OBSERVABLES,
} BeamObservable;

/* Seed of the steady response without the joint, where it stays within the clearance: an attractor that is known in
 * closed form, and may have a basin that random starts miss. */
#define BEAM_EXPERIMENT_FREE UINT64_MAX

/* Motions that are watched, and for how many cycles, where only the type is asked: enough that a half-life of
 * MOTION_CLASS_LASTS is told from a longer one. */
enum { BEAM_EXPERIMENT_LANES = 16, BEAM_EXPERIMENT_CYCLES = 2000 };

/* Number of parameters of the window for a beam's type. */
enum { BEAM_EXPERIMENT_WINDOW = 4 };
extern const char *const beam_experiment_window[BEAM_EXPERIMENT_WINDOW];

/* Opens the experiment of a beam file with `setting_count` settings and quick trials. Returns false after errors,
 * with nothing to close. */
bool beam_experiment_open(Experiment *experiment, const char *path, const char *const *settings, size_t setting_count,
                          Fault *fault);

/* Opens the experiment of a beam that is already read and must outlive it; `place` begins its errors. */
bool beam_experiment_of(Experiment *experiment, const Beam *beam, const char *place, Fault *fault);

/* Analyses each later trial fully, and watches `lanes` motions for `cycles` cycles where it is not periodic; 0: none.
 */
void beam_experiment_be_thorough(Experiment *experiment, size_t lanes, size_t cycles);

/* Runs `count` trials of one parameter one after another, the first continuing from `carry`: a carried pass in
 * pieces. */
void beam_experiment_run_on(const Experiment *experiment, const char *name, Trial *trials, size_t count,
                            BeamCarry *carry, const Stop *stop);

void beam_experiment_close(Experiment *experiment);
