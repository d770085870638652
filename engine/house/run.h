/* A house run to the end: from what is given to what is observed. */
#pragma once

#include <stdbool.h>
#include <signal.h>
#include <stddef.h>

#include "house/house.h"
#include "house/observation.h"

/* What a run that still goes on has recorded of people who have the house to themselves. */
typedef struct RunPiece {
    size_t group, group_count;       /* which of how many */
    const bool *part;                /* (person_count) who they are */
    double time;                     /* s, up to which it is recorded */
    bool over;                       /* no more will come */
    const double *rows;              /* (row_count x TRACE_COLUMNS) of the trace, since the piece before */
    size_t row_count;                /* rows */
    const PersonObservation *people; /* (person_count) of those who they are, as it stands; reasons come at the end */
    const double *door_opened;       /* (doors of the plan) as in an Observation */
} RunPiece;

typedef struct RunOptions {
    size_t route;                      /* only this route's people take part; SIZE_MAX: everybody */
    bool terse;                        /* where chairs cannot pass is told sooner and less well: journey.h */
    int jobs;                          /* threads */
    const volatile sig_atomic_t *stop; /* set: end as soon as possible; NULL: never */
    void (*progress)(void *context,
                     double time); /* now and then, from one thread, with the simulated time, s; NULL: none */
    void (*record)(void *context, const RunPiece *piece); /* as it comes, one group beside the other, each from a
                                                             thread of its own; NULL: none */
    void *context;
} RunOptions;

/* Plans everybody's journey and moves the world until everybody is out or stuck, the plan's time limit is reached or a
 * number diverges. With run.routes "alone" each route's people have the house to themselves, one route after another,
 * and those without a route come last. observation_free releases what is filled. */
void run_house(Observation *observation, const House *house, const RunOptions *options);
