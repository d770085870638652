/* How many drivers of a population get their chair through: who drives, who needs a skid or a helper, who does not fit.
 *
 * This is geometry: the route search of the nominal driver with the body of each driver, from the drawn start, without
 * errors of steering (drivers_run has those). A way on which a body goes is free for each body that is contained in it.
 * All bodies of a population have their axle equally far ahead of the rear edge, so that one that is narrower and
 * shorter is contained, and what it drives, skids or is carried along is known as soon as the larger one's way is; a
 * larger body than one that found no way finds none. With a way of clearance c, a body that is (c - 5 mm) / sqrt(2)
 * larger to the front and on both sides is contained as well. Bodies are tried where most others are decided by them,
 * on both sides of the border between yes and no.
 *
 * That a larger body finds none is proved where the smaller one does not fit (fit.h). Where a way to drive is searched
 * and not found, it assumes that the search did not fail by chance; `shares` of neighbouring widths can then be wrong
 * by the bodies in a band of some millimetres. The number of bodies that were tried is in the answer. */
#pragma once

#include "base/stop.h"
#include "house/house.h"
#include "plan/population.h"

typedef enum Passage {
    PASSAGE_NONE,    /* the body does not fit */
    PASSAGE_CARRIED, /* it fits, if a helper lifts and shifts it */
    PASSAGE_SKIDS,   /* it gets through if its drive wheels skid sideways */
    PASSAGE_DRIVES,  /* it is driven through */
    PASSAGES
} Passage;

/* The drivers in the place of one person. */
typedef struct Shares {
    size_t drivers;         /* 0: the person's profile is not the population's */
    size_t count[PASSAGES]; /* by the best passage of each driver */
    char what[96];          /* what refuses most of those who do not drive; "": nobody is refused */
    size_t refused;         /* the number of them */
    Vec2 at;                /* m, a place where it refuses */
    size_t tried;           /* number of bodies for which a route was planned */
    bool interrupted;       /* True: not all drivers are known, and nothing is counted */
} Shares;

/* Finds the shares of drivers 1 to count for each person, into `shares` (person_count); `route`: of its people alone;
 * SIZE_MAX: of all. The result does not depend on the number of threads. */
void shares_find(Shares *shares, const House *house, const Population *population, size_t count, size_t route, int jobs,
                 const Stop *stop);
