/* A house run to the end: from what is given to what is observed. */
#pragma once

#include <stdbool.h>
#include <signal.h>
#include <stddef.h>

#include "house/house.h"
#include "house/observation.h"

/* The plan from some time on: what was edited while people were in the house. */
typedef struct RunChange {
    double time;        /* s, > 0: from the first step that does not begin before it */
    const House *house; /* must outlive the run */
} RunChange;

/* What a run that still goes on has recorded of people who have the house to themselves. */
typedef struct RunPiece {
    size_t group, group_count;       /* which of how many, of all houses of the run */
    const House *house;              /* whose people and doors are meant below; a piece is of one house */
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
    int jobs;                          /* threads */
    const volatile sig_atomic_t *stop; /* set: end as soon as possible; NULL: never */
    void (*progress)(void *context,
                     double time); /* now and then, from one thread, with the simulated time, s; NULL: none */
    void (*record)(void *context, const RunPiece *piece); /* as it comes, one group beside the other, each from a
                                                             thread of its own; NULL: none */
    void *context;
    bool brief; /* for whoever waits for the answer: the same, sooner where somebody cannot pass, but that their
                   blockage names the width for carrying the chair, perhaps less than for driving it */
    const RunChange *changes; /* (change_count) rising; NULL: the plan stays as it is */
    size_t change_count;
} RunOptions;

/* Plans everybody's journey and moves the world until everybody is out or stuck, the plan's time limit is reached or a
 * number diverges. With run.routes "alone" each route's people have the house to themselves, one route after another,
 * and those without a route come last. observation_free releases what is filled.
 *
 * When the plan changes, people are known again by their ids. Who is in the house already keeps position, heading,
 * velocity and what is on the clock of a delay, looks for a way anew from there, and stays with those who were in the
 * house together; who is out stays out. New people begin at their start, their delay counted from then. Who is not in
 * the new house is gone without a trace: neither out nor blocked, since nobody asks any more whether they get out. Who
 * stands inside a wall or a piece of furniture now stays there and cannot pass. Doors that were opened stay open. The
 * springs of all contacts begin anew. dt, sample and routes of the first house hold for the whole run, everything else
 * that is set is the present house's. The run goes on until no change is left, or to the time limit. The observation is
 * told in terms of the last house of all, also where observation->mixed_count, the changes that were applied before the
 * end, are fewer. */
void run_house(Observation *observation, const House *house, const RunOptions *options);
