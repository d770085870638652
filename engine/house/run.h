/* A house run to the end: from what is given to what is observed. */
#pragma once

#include <stdbool.h>
#include <signal.h>
#include <stddef.h>

#include "house/house.h"
#include "house/observation.h"

typedef struct RunOptions {
    size_t route;                      /* only this route's people take part; SIZE_MAX: everybody */
    int jobs;                          /* threads */
    const volatile sig_atomic_t *stop; /* set: end as soon as possible; NULL: never */
    void (*progress)(void *context,
                     double time); /* now and then, from one thread, with the simulated time, s; NULL: none */
    void *context;
} RunOptions;

/* Plans everybody's journey and moves the world until everybody is out or stuck, the plan's time limit is reached or a
 * number diverges. With run.routes "alone" each route's people have the house to themselves, one route after another,
 * and those without a route come last. observation_free releases what is filled. */
void run_house(Observation *observation, const House *house, const RunOptions *options);
