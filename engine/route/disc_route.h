/* The path of a disc: see disc_route.c. */
#pragma once

#include <stdbool.h>

#include "route/route.h"
#include "route/search.h"

/* Continues `track` from its last pose to the goal for a disc of `radius` m, with poses about 5 cm apart that head
 * along the path and have their clearances filled in. The time field comes from `fields`. `lifts`: points of the grid
 * that are hardly too near an obstacle are moved away from it. Returns false, with the track unchanged, if there is no
 * path on this grid. */
bool disc_route_leg(SearchTrack *track, Fields *fields, const Plan *plan, const FreeSpace *space,
                    const Profile *profile, double radius, const Goal *goal, bool lifts);

/* Finds the path from a query's start through all goals in order, on the query's grid or, where gaps are hardly wider
 * than the disc, on a finer one, whose points are lifted in the end. Returns false, with the part of the path that was
 * found, if there is none, or if interrupted. */
bool disc_route_find(SearchTrack *track, const RouteQuery *query, const Goal *goals, size_t goal_count, double radius);
