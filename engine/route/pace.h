/* The speed at which a driver takes a place on a path, for the planning of the path and for the drive along it. */
#pragma once

#include "plan/profile.h"

/* 1, assumed: the share of the deceleration that a driver plans with, before corners, doors, exits and people; the rest
 * is a reserve. */
#define PACE_PLANNED 0.8

/* 1, assumed: the shares of the turning moment that the change of the curvature may ask for, with the curvature
 * averaged over some 0.2 m, as a path is planned, and from step to step, as it is driven. */
#define PACE_MOMENT 0.5
#define PACE_OWN_MOMENT 0.85

/* How a driver plans to turn. */
typedef struct Agility {
    double acceleration; /* rad/s2: PACE_MOMENT of the turning moment over the inertia about the axle */
    double rate;         /* rad/s: nine tenths of the turn rate, and what half of the push holds the mass centre at */
    double swing;        /* m/s2, across: PACE_MOMENT of the turning moment over m c; infinite without a mass centre */
    double sharpest;     /* rad/m, the greatest curvature that can be driven at all */
} Agility;

Agility pace_agility(const Profile *profile);

/* Returns the agility's acceleration alone, rad/s2. */
double pace_turning(const Profile *profile);

/* Returns the speed, m/s, of a driver who takes a passage at most at `passage` m/s (foresight.h) and is as agile as
 * `agility` says, where the body has `clearance` m, the path's curvature is `curvature` rad/m and changes by `bending`
 * rad/m2; `direction` is -1 backwards.
 *
 * Clearance: in the middle of a straight passage the clearance on either side is (W - w) / 2; where the body turns, or
 * the path leads close by an obstacle, the same law holds with twice the clearance, with the floor of the paper for
 * corners, drive.minimum_speed. With less than body.hands beside the rims the arms are tucked in: PACE_TUCKED_SPEED.
 * Curvature k: v^2 k <= the lateral acceleration, v k <= nine tenths of the turn rate, since a driver who turns as
 * quickly as possible cannot come back to the path, and of the rate w at which half of the push holds the mass centre,
 * c ahead of the axle: m c w^2 <= push / 2; m c v^2 k <= half of the turning moment, since the drive wheels hold the
 * axle and the mass centre swings the chair straight. Bending: I v^2 dk/ds <= half of the turning moment. A bend is
 * taken at 0.03 m/s, however narrow it is and however weak the driver. */
double pace_at(const Profile *profile, const Agility *agility, double passage, double clearance, double curvature,
               double bending, int direction);

/* Returns the speed, m/s, up to `free`, that the width W of the passage alone allows: v = (W - w) / b, but no less than
 * drive.creep. */
double pace_in_passage(const Profile *profile, double free, double width);

/* 1 and m/s, assumed: the share of the push that is left with the arms tucked in, and the greatest speed then. */
#define PACE_TUCKED_PUSH 0.3
#define PACE_TUCKED_SPEED 0.3

/* Return the acceleration from rest and the deceleration, m/s2, that a driver plans with at a clearance, m: no more
 * than the push can do. A chair of the paper does not plan: it slows down with a_d. */
double pace_starting(const Profile *profile, double clearance);
double pace_braking(const Profile *profile, double clearance);

/* Returns the turning moment, N m, that a turn on the spot takes (strength.h): the scrub of the tyres, and what brings
 * the inertia about the axle to w = 0.1 rad/s within phi = 1 rad, both assumed: drive.scrub + I w^2 / (2 phi). */
double pace_spot_moment(const Profile *profile);

/* Returns the greatest curvature that can be driven at all, rad/m; a sharper bend is a turn on the spot. */
double pace_sharpest(const Profile *profile);

/* Returns the change of speed, m/s2, that half of the turning moment M, which causes the angular acceleration `turning`
 * (rad/s2), allows in a bend of `curvature` k, rad/m, since the turn rate changes with the speed: I k a <= M / 2.
 * Infinite on the straight. */
double pace_in_bend(double turning, double curvature);

/* Returns alpha, s: the error of a driver across the way has the standard deviation alpha v, and a driver keeps z of
 * them (drive.caution) from the wall, so that v = c / (z alpha) = 2 c / b with b = 2 z alpha, drive.steering_time. */
double pace_error(const Profile *profile);

/* Returns what the personal space, pressed where the body has the clearances `left` and `right` (m), costs beyond the
 * time, s/m: space.price (d_L^2 + d_R^2) / reach^2 with d how deep it is pressed on a side. Between walls the sum is
 * least in the middle. */
double pace_price(const Profile *profile, double left, double right);

/* Returns the clearance from which on it does not slow a driver, m. */
double pace_enough(const Profile *profile);
