/* A run of a house: computed on a worker's thread and handed over in parts meanwhile. */
#pragma once

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/stop.h"
#include "house/house.h"
#include "house/observation.h"
#include "draw/scene.h"
#include "inquiry/grade.h"
#include "laboratory/house/crew.h"
#include "laboratory/house/history.h"
#include "laboratory/house/outlook.h"

/* The kinds of jobs of the worker. */
typedef enum HouseJob {
    HOUSE_JOB_RUN,    /* the run of a plan */
    HOUSE_JOB_MIXED,  /* the run of a plan that changes */
    HOUSE_JOB_RIVAL,  /* the run of another driving model, for comparison */
    HOUSE_JOB_ROUTES, /* only the planned routes, as a scene */
    HOUSE_JOB_GRADES, /* the grades of the ways, their letters alone */
    HOUSE_JOB_CREW,   /* many drivers, as scenes */
    HOUSE_JOB_SHAKES, /* many earthquakes */
    HOUSE_JOBS,
} HouseJob;

typedef struct HouseWish {
    HouseJob job;
    const char *path;         /* path of the house file, for faults and for profiles in the same folder */
    const HouseEpoch *epochs; /* (epoch_count) the plans */
    size_t epoch_count;
    const char *profiles;        /* directory of the shipped profiles */
    const char *route;           /* id, or NULL: all people */
    const char *const *settings; /* (setting_count) NAME=VALUE that the plans are read with */
    size_t setting_count;
    int driving; /* Driving, or -1 */
    uint64_t seed;
    int jobs;              /* threads */
    bool brief;            /* as RunOptions.brief */
    struct Recall *recall; /* as RunOptions.recall: that of the session, which outlives the run */
} HouseWish;

typedef enum HouseStage {
    HOUSE_WAITS,
    HOUSE_READS,
    HOUSE_PLANS,   /* the house is read, nothing is recorded */
    HOUSE_DRIVES,  /* a part is recorded */
    HOUSE_OVER,    /* the observation, or the routes, are complete */
    HOUSE_FAILED,  /* the fault says why the house is invalid */
    HOUSE_STOPPED, /* the record ends here: no more rows follow */
} HouseStage;

typedef struct HouseRun {
    HouseWish wish;
    Arena arena; /* holds the texts of the wish */

    /* Belongs to the worker until the stage says that it is complete; constant afterwards. */
    House house;    /* the house of the last epoch */
    House *earlier; /* (wish.epoch_count - 1) the houses of the earlier epochs */
    Observation observation;
    Scene routes;
    Grade *grades;                   /* (house.person_count) of HOUSE_JOB_GRADES */
    Crew crews[CREW_STEPS];          /* (crew_count) */
    Outlook outlooks[OUTLOOK_STEPS]; /* (outlook_count) */
    Fault fault;

    unsigned roles; /* the run's roles in the session: see runs.h */
    bool noticed;   /* the session has noticed the end of the run */

    Stop stop;
    pthread_mutex_t mutex; /* guards all members that follow */
    HouseStage stage;
    int crew_count, outlook_count; /* steps that are complete */
    double begun;                  /* s, of a steady clock, when the worker began */
    Trace fresh;                   /* rows that are recorded and not taken yet */
    double *reach;                 /* (group_count) s, end of each group's record; infinite: the group is complete */
    size_t group_count;
    PersonObservation *people; /* (house.person_count) the present state */
    double *door_opened;       /* (doors of the plan) */
} HouseRun;

/* Creates a run with a copy of the wish. house_run_destroy releases it; a run that has been given to a worker is
 * abandoned instead. */
HouseRun *house_run_create(const HouseWish *wish);
void house_run_destroy(HouseRun *run);

/* Returns the draft's revision of the last epoch. */
static inline uint64_t house_run_revision(const HouseRun *run) {
    return run->wish.epochs[run->wish.epoch_count - 1].revision;
}

/* Returns the index of the epoch at a time. */
size_t house_run_epoch(const HouseRun *run, double time);

/* True if both have the same people and exits: then the observation of one can be displayed in the other. */
bool house_run_alike(const House *a, const House *b);

/* Returns the house of an epoch if it has the same people and exits as the last one, otherwise the last house. */
const House *house_run_house(const HouseRun *run, size_t epoch);

/* Computes the run on this thread until it is complete, has failed or is stopped. */
void house_run_make(HouseRun *run);

HouseStage house_run_stage(HouseRun *run);

/* Return the drivers, or the earthquakes, of the last complete step, or NULL. */
const Crew *house_run_crew(HouseRun *run);
const Outlook *house_run_outlook(HouseRun *run);

/* Returns the time since the worker began the run, s. */
double house_run_age(HouseRun *run);

/* Returns the time up to which everything is recorded, s; further rows come after it. */
double house_run_reach(HouseRun *run);

/* Writes the progress: "computed 12.3 s", or, with the name of a driving model, "miura: computed 12.3 s". False: the
 * run is over. */
bool house_run_describe(HouseRun *run, const char *model, char *text, size_t size);

/* Returns an observation of all people in the run, without rows; house_run_copy_rows fills it. */
Observation house_run_begin(const HouseRun *run);

/* Takes over the rows recorded since the last call if there are at least `least`; returns their number. */
size_t house_run_copy_rows(HouseRun *run, Observation *growing, size_t least);
