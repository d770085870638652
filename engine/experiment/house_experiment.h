/* A house as an experiment: parameters are the numbers that `--set` accepts; each run reads the house with its
 * values, plans the routes and simulates the evacuation. */
#pragma once

#include "house/house.h"
#include "experiment/locus_record.h"
#include "plan/population.h"
#include "experiment/shake_record.h"
#include "study/experiment.h"

/* Indices into the observables. */
enum {
    HOUSE_COMPLETED,
    HOUSE_TIME, /* NAN: a person is not out */
    HOUSE_NARROWEST,
    HOUSE_PEAK_FORCE,
    HOUSE_CONTACTS,
    HOUSE_RING_TIME,
    HOUSE_LOST_TIME, /* NAN: a person is not out */
    HOUSE_NOT_OUT,
    HOUSE_WAY,
    HOUSE_OBSERVABLES,
};

/* Reads the house for its names and nominal values. `path` and `options` must stay valid until the experiment is
 * closed. A run with seed 0 uses the seed of the options. With options->shake each run begins with the earthquake of
 * its seed and returns more observables: see shake_record.h. `route`: only the people of that route take part; NULL:
 * all people. Returns false after errors with places and reasons. */
bool house_experiment_open(Experiment *experiment, const char *path, const HouseOptions *options, const char *route,
                           Fault *fault);

/* Opens the experiment of a house file's `text`, which must stay valid, too; `path` is then its name for faults and
 * profiles. NULL: the text is that of the file. */
bool house_experiment_open_text(Experiment *experiment, const char *path, const char *text, const HouseOptions *options,
                                const char *route, Fault *fault);

/* Lets a driver of a population drive in each run: the run with the seed of the options has driver 1, that with the
 * next seed driver 2. So each point of a study has the same drivers, and chance stays that of the options' seed. Takes
 * the population over. */
void house_experiment_drive(Experiment *experiment, Population *population);

/* Adds the observables of a measured locus of a person: see locus_record.h. Not after a shake. Returns the record,
 * which belongs to the experiment; its count is 0 if the locus is too short. */
const LocusRecord *house_experiment_follow(Experiment *experiment, const Locus *measured, size_t person);

/* Adds the worst grade of each run in which all people are out, at most `few`, as an observable, and its place as the
 * note: see grade_record.h. Neither after a shake nor with a locus. */
void house_experiment_grade(Experiment *experiment, size_t few);

void house_experiment_close(Experiment *experiment);

/* Return the house with nominal values, before any shake; and the record of shakes, or NULL. */
const House *house_experiment_house(const Experiment *experiment);
const ShakeRecord *house_experiment_shake(const Experiment *experiment);
