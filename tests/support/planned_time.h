/* The duration of a planned route, for tests that compare routes. */
#pragma once

#include "house/house.h"
#include "route/route.h"

/* Returns the time, s, from rest at the start to the exit's line: the speeds of track_build_driver, reached with the
 * profile's acceleration; its turn rate on the spot; and its reversing time per change of direction. Only the plan, the
 * outline and the free space of the house are used. */
double planned_time(const House *house, const Profile *profile, const Route *route);
