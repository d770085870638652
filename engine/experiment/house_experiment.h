/* A house as an experiment: what a study varies is what `--set` accepts as a number; each run reads the house anew with
 * its values, plans the ways and lets everybody leave. */
#pragma once

#include "house/house.h"
#include "experiment/shake_record.h"
#include "study/experiment.h"

/* Indices into the observables. */
enum {
    HOUSE_COMPLETED,
    HOUSE_TIME, /* NAN: somebody is not out */
    HOUSE_NARROWEST,
    HOUSE_PEAK_FORCE,
    HOUSE_CONTACTS,
    HOUSE_RING_TIME,
    HOUSE_LOST_TIME, /* NAN likewise */
    HOUSE_NOT_OUT,
    HOUSE_WAY,
    HOUSE_OBSERVABLES,
};

/* Reads the house for its names and nominal values. What `path` and `options` point at must stay until the experiment
 * is closed. A run with seed 0 takes that of the options. With options->shake each run begins with the earthquake of
 * its seed, of which more is observed: shake_record.h. `route`: only its people take part; NULL: everybody. False:
 * faults say where and what. */
bool house_experiment_open(Experiment *experiment, const char *path, const HouseOptions *options, const char *route,
                           Fault *fault);
void house_experiment_close(Experiment *experiment);

/* The house with nominal values, as before any shake; and where it is told of shakes, if it is. */
const House *house_experiment_house(const Experiment *experiment);
const ShakeRecord *house_experiment_shake(const Experiment *experiment);
