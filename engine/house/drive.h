/* The driving force: what a person does to follow the track (F3 of the paper, and F4 in `miura`). */
#pragma once

#include <stddef.h>

#include "base/vec2.h"
#include "house/world.h"

/* What the person exerts in this step. */
typedef struct Effort {
    Vec2 force;    /* N, on the mass centre */
    double moment; /* N m */
} Effort;

/* Looks at the frozen state, moves the person's own Drive on, and returns the effort. */
Effort drive_person(const World *world, size_t i, Drive *drive);

/* The wheels of a driver's chair hold it sideways: removes the side-slip of the axle by an impulse, up to friction. */
void drive_hold_sideways(const Profile *profile, double dt, Vec2 axis, Vec2 *velocity, double *turn);

/* The track's next shut door that the person has come up to, or -1: it stands before it and may open it. */
int drive_door_at_hand(const World *world, size_t i);
