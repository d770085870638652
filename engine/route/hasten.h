/* Makes a free way quick: see hasten.c. */
#pragma once

#include <stdbool.h>

#include "base/stop.h"
#include "plan/profile.h"
#include "route/way.h"

/* Moves the stations as long as the time falls and every clearance stays at least `margin` m, in `sweeps` sweeps.
 * Returns false if interrupted. */
bool hasten_way(Way *way, const FreeSpace *space, const Rectangle *body, const Profile *profile, double margin,
                int sweeps, const Stop *stop);

/* Returns the time of a way from rest, s, by the speed law, with the planned deceleration. */
double hasten_time(const Way *way, const FreeSpace *space, const Rectangle *body, const Profile *profile);
