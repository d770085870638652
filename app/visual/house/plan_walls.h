/* The outlines of a plan's walls for pictures, by height. Uniting walls takes longer than anything else in a picture of
 * a house, and from one picture to the next most edits leave walls and doors as they are. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "space/outline.h"

/* Walls of one height, or all walls from the cut upwards. */
typedef struct WallBand {
    Rings rings;
    double shown; /* m, the height that a picture shows */
} WallBand;

/* Zero is empty; plan_walls_clear releases it. */
typedef struct PlanWalls {
    WallBand *bands; /* (count), rising */
    size_t count, capacity;
    double *key; /* (key_count) all numbers on which the outlines depend */
    size_t key_count, key_capacity;
} PlanWalls;

void plan_walls_clear(PlanWalls *walls);

/* Makes the bands those of a plan whose walls are cut at that height, m; false: they were its bands already, and are
 * kept. */
bool plan_walls_update(PlanWalls *walls, const Plan *plan, double cut);
