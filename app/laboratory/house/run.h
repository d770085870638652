/* A run of a house: computed on a worker's thread, handed over bit by bit meanwhile. */
#pragma once

#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "house/house.h"
#include "house/observation.h"
#include "draw/scene.h"
#include "laboratory/house/history.h"

/* The kinds of jobs of the worker. */
typedef enum HouseJob {
    HOUSE_JOB_RUN,   /* the run of a plan */
    HOUSE_JOB_MIXED, /* one in which the plan changes */
    HOUSE_JOB_RIVAL, /* one to compare it with */
    HOUSE_JOB_WAYS,  /* only the planned ways, as a scene */
    HOUSE_JOBS,
} HouseJob;

typedef struct HouseWish {
    HouseJob job;
    const char *path;         /* of the house file, for faults and for profiles beside it */
    const HouseEpoch *epochs; /* (epoch_count) of the plan */
    size_t epoch_count;
    const char *profiles; /* directory of the shipped ones */
    const char *route;    /* id, or NULL: everybody */
    int driving;          /* Driving, or -1 */
    uint64_t seed;
    int jobs;   /* threads */
    bool brief; /* as RunOptions.brief */
} HouseWish;

typedef enum HouseStage {
    HOUSE_WAITS,
    HOUSE_READS,
    HOUSE_PLANS,   /* the house is there, nothing is recorded */
    HOUSE_DRIVES,  /* something is */
    HOUSE_OVER,    /* the observation, or the ways, are there */
    HOUSE_FAILED,  /* the fault says why there is no house */
    HOUSE_STOPPED, /* what is recorded is all that there will be */
} HouseStage;

typedef struct HouseRun {
    HouseWish wish;
    Arena arena; /* holds it */

    /* The worker's, until the stage says that they are there; then they stay as they are. */
    House house;    /* of the last epoch */
    House *earlier; /* (wish.epoch_count - 1) of those before */
    Observation observation;
    Scene ways;
    Fault fault;

    unsigned roles; /* in which the session has it: see runs.h */
    bool noticed;   /* by the session, that it is over */

    volatile sig_atomic_t stop;
    pthread_mutex_t mutex; /* of all that follows */
    HouseStage stage;
    double begun;  /* s, of a steady clock, when the worker began */
    Trace fresh;   /* recorded and not taken yet */
    double *reach; /* (group_count) s, recorded of each group; infinite: to its end */
    size_t group_count;
    PersonObservation *people; /* (house.person_count) as they stand */
    double *door_opened;       /* (doors of the plan) */
} HouseRun;

/* A copy of the wish. house_run_destroy releases it; a run that has been given to a worker is abandoned instead.
 */
HouseRun *house_run_create(const HouseWish *wish);
void house_run_destroy(HouseRun *run);

/* The draft's revision at its end. */
static inline uint64_t house_run_revision(const HouseRun *run) {
    return run->wish.epochs[run->wish.epoch_count - 1].revision;
}

/* Which epoch a time is in. */
size_t house_run_epoch(const HouseRun *run, double time);

/* True if both have the same people and exits: then the observation of one can be displayed in the other. */
bool house_run_alike(const House *a, const House *b);

/* The house of an epoch, as far as that is like the one at the end; otherwise that of the end. */
const House *house_run_house(const HouseRun *run, size_t epoch);

/* Makes the run, on this thread, until it is over, has failed or is stopped. */
void house_run_make(HouseRun *run);

HouseStage house_run_stage(HouseRun *run);

/* s, for how long it has been in work. */
double house_run_age(HouseRun *run);

/* s, up to when everything is recorded; more will come after it. */
double house_run_reach(HouseRun *run);

/* Writes the progress after `who`, "computed 12.3 s"; false: the run is over. */
bool house_run_say(HouseRun *run, const char *who, char *words, size_t size);

/* Returns an observation of all people in the run, without rows; house_run_take fills it. */
Observation house_run_begin(const HouseRun *run);

/* Takes over what has been recorded since the last time, when that are at least so many rows; returns how many. */
size_t house_run_take(HouseRun *run, Observation *growing, size_t least);
