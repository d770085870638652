/* The line that a driver aims at, beside the planned one, with the personal space as a stimulus and with errors of
 * steering: see aim.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "house/place.h"
#include "house/world.h"

/* True if the personal space makes person i steer, and does not push: house_ring. */
bool aim_steers(const World *world, size_t i);

/* Advances the aim of person i, who drives in a direction, 1 or -1, by a step, and looks for what is in the way. */
void aim_take(const World *world, size_t i, Drive *drive, const Place *place, int direction);

/* Returns the slope, 1, at which the axle follows the front edge away from the plan. */
double aim_slope(const Profile *profile, const Drive *drive);

/* Returns the error of the heading, rad, with which person i ends the turn on the spot that leads to the track's point
 * `end`. */
double aim_spot_error(const World *world, size_t i, size_t end);
