/* The shut doors that a body opens along a path: those that it goes through, and those into whose doorway, or before
 * whose leaf, it only swings. */
#pragma once

#include <stddef.h>

#include "base/vec2.h"
#include "plan/plan.h"
#include "plan/profile.h"

/* A place of the body along the path. */
typedef struct DoorwayPlace {
    Vec2 at;   /* m, of the reference point */
    Vec2 axis; /* unit, of the body */
} DoorwayPlace;

/* Fills in, for each of `count` places, the door that the body first obstructs there, and again when it comes back, so
 * that it must be opened, or -1. A door that it only comes by stays shut. */
void doorway_mark(int *doors, const DoorwayPlace *places, size_t count, const Plan *plan, const Profile *profile);

/* Returns the time for which the body waits until these doors are open, s. */
double doorway_delay(const DoorwayPlace *places, size_t count, const Plan *plan, const Profile *profile);
