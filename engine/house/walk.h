/* The velocity that a walker wants, decided every WALK_PERIOD s rather than at every step.
 *
 * See walk.c for the law and its sources. */
#pragma once

#include "space/freespace.h"
#include "house/walkers.h"

#define WALK_PERIOD 0.1 /* s: assumed, about the reaction time of a person */

/* The decision state of a walker. */
typedef struct Walk {
    Vec2 wish;      /* m/s, wanted velocity */
    double best;    /* s, least time to the goal so far */
    double stalled; /* s, without progress */
    double held;    /* s, without being able to move */
    double handle;  /* s, spent at a shut door's handle */
    int door;       /* door whose handle is held, or -1 */
    int leg;        /* leg of the journey */
    int departures; /* number of departures at the last attempt */
} Walk;

struct World;

/* Decides for person i, who stands in `slot`, and fills in world->walk[i]. Reads the present state of all people and
 * writes only data of person i. */
void walk_decide(struct World *world, size_t i, uint32_t slot);
