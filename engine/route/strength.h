/* Tells the driver who is too weak for a path at any speed.
 *
 * On the level nothing holds a chair back but its inertia and, in a turn on the spot, the scrub of its tyres (the row
 * drive.scrub). Slopes and rolling resistance are not in the model. With m the mass, I that about the drive axle and
 * limits that are all assumed, a way takes
 *
 *     from rest    m v^2 / (2 d)            of push: the creep speed v (pace.h) within d = 0.5 m; where arms are tucked
 *                                           in, PACE_TUCKED_PUSH of the push is left
 *     on the spot  scrub + I w^2 / (2 phi)  of turning moment: w = 0.1 rad/s within phi = 1 rad
 *     in a bend    I u^2 k / l              of turning moment: the turn rate u k, k the curvature averaged over
 *                                           l = 0.2 m, at u = 0.03 m/s, at which any bend is planned, within l; a
 *                                           bend of more than 10 m in radius is none */
#pragma once

#include <stdbool.h>

#include "route/route.h"

/* Returns the way of a driver, as route_drive does, but ROUTE_TOO_WEAK where there is one for others alone: for a
 * driver who cannot turn on the spot it is searched without such turns, and then with turns that have to become bends.
 * The blockage then has the place that lacks most of what it needs. */
Route strength_drive(const RouteQuery *query);

/* The same for a round body, as route_round does, which needs no moment. */
Route strength_round(const RouteQuery *query);

/* Makes a route that was found ROUTE_TOO_WEAK if this profile is too weak for it; `round`: of a round body. */
void strength_test(Route *route, const Profile *profile, bool round);

/* Gives a profile the strength that every way takes, as far as it has less. */
void strength_suffice(Profile *profile);
