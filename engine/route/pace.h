/* The speed at which a driver takes a place on a path, for the planning of the path and for the drive along it. */
#pragma once

#include "plan/profile.h"

/* m/s, assumed: speed through a gap hardly wider than the body. */
#define PACE_CREEP 0.1

/* 1, assumed: the share of the deceleration that a driver plans with, before corners, doors, exits and people; the rest
 * is a reserve. */
#define PACE_PLANNED 0.8

/* Returns the speed, m/s, of a driver whose free speed is `free` m/s, where the body has `clearance` m, the path's
 * curvature is `curvature` rad/m and changes by `bending` rad/m2; `direction` is -1 backwards.
 *
 * Clearance: in the middle of a straight passage the clearance on either side is (W - w) / 2; where the body turns, or
 * the path leads close by an obstacle, the same law holds with twice the clearance, with the floor of the paper for
 * corners. Curvature k: v^2 k <= the lateral acceleration, v k <= nine tenths of the turn rate, since a driver who
 * turns as quickly as possible cannot come back to the path. Bending: I v^2 dk/ds <= half of the turning moment. */
double pace_at(const Profile *profile, double free, double clearance, double curvature, double bending, int direction);

/* Returns the clearance from which on it does not slow a driver, m. */
double pace_enough(const Profile *profile);
