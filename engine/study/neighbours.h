/* How far away trouble is: one parameter at a time is moved outwards, in steps of 0.5 % and then 1 % up to 20 %, from a
 * few starts each, to the first value at which the answer is another kind than here: not regular where it is regular
 * here; regular from every start where it is not. */
#pragma once

#include "study/experiment.h"

enum {
    NEIGHBOURS_FINE = 10,  /* steps of 0.5 %: to 5 % */
    NEIGHBOURS_STEPS = 25, /* the others of 1 %: to 20 % */
    NEIGHBOURS_STARTS = 4, /* seeds 0 to 3 */
};

typedef enum NeighboursSought { NEIGHBOURS_TROUBLE, NEIGHBOURS_REGULAR } NeighboursSought;

/* What is on one side of one parameter. */
typedef struct Neighbour {
    bool found;
    double value;   /* of the parameter, where it was found */
    double share;   /* 1, how far away: value / nominal - 1 */
    double reached; /* 1, how far was looked: below 0.2 when a value was out of range or it was stopped */
    size_t runs;
} Neighbour;

/* Looks on the sides of each of the names (name_count); `sides` (name_count x 2): below, above. A parameter that is 0
 * has none. `done` is called with the number of trials that a side need not make any more; from any thread. */
typedef struct NeighboursTask {
    const Experiment *experiment;
    const char *const *names;
    size_t name_count;
    NeighboursSought sought;
    int jobs;
    const volatile sig_atomic_t *stop;
    void (*done)(void *context, size_t trials);
    void *context;
} NeighboursTask;

void neighbours_find(const NeighboursTask *task, Neighbour *sides);

/* 1, how far the step (from 0) goes. */
double neighbours_share(size_t step);
