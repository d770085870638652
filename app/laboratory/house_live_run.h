/* A run of a house for whoever watches it: made on a worker's thread, handed over bit by bit while it is made. */
#pragma once

#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "house/house.h"
#include "house/observation.h"

/* What is to be run. */
typedef struct HouseWish {
    const char *path;            /* of the house file */
    const char *profiles;        /* directory of the shipped ones */
    const char *const *settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    const char *route; /* id, or NULL: everybody */
    int driving;       /* Driving, or -1 */
    uint64_t seed;
    int jobs; /* threads */
} HouseWish;

typedef enum HouseStage {
    HOUSE_WAITS,
    HOUSE_READS,
    HOUSE_PLANS,   /* the house is there, nothing is recorded */
    HOUSE_DRIVES,  /* something is */
    HOUSE_OVER,    /* the observation is there */
    HOUSE_FAILED,  /* the fault says why there is no house */
    HOUSE_STOPPED, /* what is recorded is all that there will be */
} HouseStage;

typedef struct HouseRun {
    HouseWish wish;
    double *values; /* what the one who asks wants to know again of it, see house_live_run_note; or NULL */
    Arena arena;    /* holds both */

    /* The worker's, until the stage says that they are there; then they stay as they are. */
    House house;
    Observation observation;
    Fault fault;

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

/* A copy of the wish. house_live_run_destroy releases it; a run that has been given to a worker is abandoned instead.
 */
HouseRun *house_live_run_create(const HouseWish *wish);
void house_live_run_destroy(HouseRun *run);

/* Keeps a copy of some values (count). */
void house_live_run_note(HouseRun *run, const double *values, size_t count);

/* Makes the run, on this thread, until it is over, has failed or is stopped. */
void house_live_run_make(HouseRun *run);

HouseStage house_live_run_stage(HouseRun *run);

/* s, for how long it has been in work. */
double house_live_run_age(HouseRun *run);

/* s, up to when everything is recorded; more will come after it. */
double house_live_run_reach(HouseRun *run);

/* An observation without rows, to be filled by house_live_run_take: of everybody who takes part. */
Observation house_live_run_begin(const HouseRun *run);

/* Takes over what has been recorded since the last time, when that are at least so many rows; returns how many. */
size_t house_live_run_take(HouseRun *run, Observation *growing, size_t least);
