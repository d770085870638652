/* Runs a house to the end and returns the observation. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "house/house.h"
#include "house/journey.h"
#include "house/observation.h"

/* The plan from some time on, edited while people were in the house. */
typedef struct RunChange {
    double time;        /* s, > 0: applied at the first step that does not begin earlier */
    const House *house; /* must outlive the run */
} RunChange;

/* Records of a run in progress, for people who have the house to themselves. */
typedef struct RunPiece {
    size_t group, group_count;       /* index and number of groups, over all houses of the run */
    const House *house;              /* house of the people and doors below; a piece belongs to one house */
    const bool *part;                /* (person_count) True for members of the group */
    double time;                     /* s, end of the recorded time */
    bool over;                       /* True for the last piece */
    const double *rows;              /* (row_count x TRACE_COLUMNS) rows of the trace since the previous piece */
    size_t row_count;                /* number of rows */
    const PersonObservation *people; /* (person_count) current observations of the members; reasons come at the end */
    const double *door_opened;       /* (doors of the plan) as in an Observation */
} RunPiece;

typedef struct RunOptions {
    size_t route;     /* only this route's people take part; SIZE_MAX: all people */
    int jobs;         /* threads */
    const Stop *stop; /* requested: end as soon as possible, as an interrupted observation; NULL: never */
    void (*progress)(void *context,
                     double time); /* called sometimes, from one thread, with the simulated time, s; NULL: none */
    void (*record)(void *context, const RunPiece *piece); /* called with new records, for all groups concurrently, each
                                                             from a thread of its own; NULL: none */
    void *context;
    bool brief; /* True for quick results: if a person cannot pass, the blockage names the width for carrying the chair,
                   which may be less than for driving it */
    Recall *recall;           /* answers kept for this and other houses; NULL: none, with the same result */
    const Journeys *known;    /* routes that drivers follow (journey_follow); NULL: they plan */
    const RunChange *changes; /* (change_count) by rising time; NULL: the plan does not change */
    size_t change_count;
} RunOptions;

/* Plans the journeys of all people and moves the world until every person is out or stuck, the plan's time limit is
 * reached or a number diverges. With run.routes "alone" each route's people have the house to themselves, one route
 * after another, and people without a route come last. observation_free releases the result.
 *
 * When the plan changes, people are matched by id. A person who is in the house keeps position, heading, velocity and
 * elapsed delay, gets a new path from there, and stays with the people of the same group; a person who is out stays
 * out. New people begin at their start, with their delay counted from then. A person who is not in the new house is
 * removed from the results: neither out nor blocked. A person who now stands inside a wall or a piece of furniture
 * stays there and cannot pass. Doors that were opened stay open. The springs of all contacts restart. dt, sample and
 * routes of the first house hold for the whole run; all other settings are those of the present house. The run
 * continues until no change is left, or to the time limit. The observation refers to the last house, even if fewer
 * changes, observation->mixed_count, were applied before the end. */
void run_house(Observation *observation, const House *house, const RunOptions *options);
