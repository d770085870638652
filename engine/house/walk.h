/* Where somebody on foot wants to go, and how fast: decided every WALK_PERIOD s, not at every step.
 *
 * See walk.c for the law and its sources. */
#pragma once

#include "space/freespace.h"
#include "house/walkers.h"

#define WALK_PERIOD 0.1 /* s: assumed, about the reaction time of a person */

/* What a walker is about. */
typedef struct Walk {
    Vec2 wish;      /* m/s, the velocity wanted */
    double best;    /* s, the least time to the goal so far */
    double stalled; /* s, without getting on */
    double held;    /* s, without being able to move */
    double handle;  /* s, spent at a shut door's handle */
    int door;       /* whose handle, or -1 */
    int leg;        /* of the journey */
    int departures; /* of others that had been seen then */
} Walk;

struct World;

/* Decides for person i, who stands in `slot`: fills world->walk[i]. Reads everybody's present state and writes only
 * what belongs to person i. */
void walk_decide(struct World *world, size_t i, uint32_t slot);
