/* Finds the distance to the next change of response: each parameter in turn is moved outwards, in steps of 0.5 % and
 * then 1 % up to 20 %, from a few initial states each, to the first value with a different response: irregular where
 * the centre is regular, or regular from every initial state where it is not. */
#pragma once

#include "base/stop.h"
#include "study/experiment.h"

enum {
    NEIGHBOURS_FINE = 10,  /* steps of 0.5 %, up to 5 % */
    NEIGHBOURS_STEPS = 25, /* all steps; the later ones of 1 %, up to 20 % */
    NEIGHBOURS_STARTS = 4, /* seeds 0 to 3 */
};

typedef enum NeighboursSought { NEIGHBOURS_TROUBLE, NEIGHBOURS_REGULAR } NeighboursSought;

typedef enum NeighbourAnswer {
    NEIGHBOUR_NONE, /* up to `reached`, which is below 0.2 if a value was out of range */
    NEIGHBOUR_FOUND,
    NEIGHBOUR_INTERRUPTED, /* value, share and `reached` are NAN */
} NeighbourAnswer;

/* The result on one side of one parameter. */
typedef struct Neighbour {
    NeighbourAnswer answer;
    double value;   /* parameter value at the change */
    double share;   /* 1, distance: value / nominal - 1 */
    double reached; /* 1, range examined */
    size_t runs;
} Neighbour;

/* Examines both sides of each name (name_count); `sides` (name_count x 2): below, above. A parameter that is 0 has
 * no sides. `done`, called from any thread, receives the number of trials that a side no longer needs. */
typedef struct NeighboursTask {
    const Experiment *experiment;
    const char *const *names;
    size_t name_count;
    NeighboursSought sought;
    int jobs;
    const Stop *stop;
    void (*done)(void *context, size_t trials);
    void *context;
} NeighboursTask;

void neighbours_find(const NeighboursTask *task, Neighbour *sides);

/* Returns the relative distance of a step (from 0), 1. */
double neighbours_share(size_t step);
