/* The driving force: how a person follows the track (F3 of the paper, and F4 in `miura`). */
#pragma once

#include <stddef.h>

#include "base/vec2.h"
#include "house/world.h"

/* Force and moment that the person exerts in this step. */
typedef struct Effort {
    Vec2 force;    /* N, on the mass centre */
    double moment; /* N m */
} Effort;

/* Reads the frozen state, advances the person's own Drive, and returns the effort. */
Effort drive_person(const World *world, size_t i, Drive *drive);

/* Removes the side-slip of the axle by an impulse, up to friction, since the wheels hold a driver's chair sideways. */
void drive_hold_sideways(const Profile *profile, double dt, Vec2 axis, Vec2 *velocity, double *turn);

/* Returns the track's next shut door if the person has reached it and may open it, or -1. */
int drive_door_at_hand(const World *world, size_t i);
