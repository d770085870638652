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

/* Leads a quick way along the middle of what is near, where that costs no time, or up to 0.2 % of it in all: lowers the
 * price of the pressed personal space (pace_price) in at most `sweeps` rounds. The margin and the result are those of
 * hasten_way. */
bool hasten_centre(Way *way, const FreeSpace *space, const Rectangle *body, const Profile *profile, double margin,
                   int sweeps, const Stop *stop);
