/* The way of a disc: see taut.c. */
#pragma once

#include <stdbool.h>

#include "route/route.h"
#include "route/search.h"

/* Continues `track` from its last pose to the goal for a disc of `radius` m, with poses about 5 cm apart that head
 * along the way and know their clearance. The field is taken from `fields`. False, and the track as it was: there is no
 * way on this grid. */
bool disc_route_leg(SearchTrack *track, Fields *fields, const Plan *plan, const FreeSpace *space,
                    const Profile *profile, double radius, const Goal *goal);
