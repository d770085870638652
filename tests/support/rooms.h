/* Two small houses for tests of routes, a corner and two rooms, and a chair in them. */
#pragma once

#include "route/route.h"

typedef struct Rooms {
    Vec2 points[16];
    Wall walls[4];
    Door doors[2];
    Exit exits[2];
    Furniture furniture[2];
    Plan plan;
    Outline outline;
    FreeSpace space;
    Profile profile;
    RouteQuery query;
} Rooms;

Profile rooms_chair(double length, double width);

/* A passage W1 wide comes down and turns left into one W2 wide; it is shut but for the exit's line in the second arm.
 *
 *      | W1 |
 *      |    |
 *      | v  +----------
 *      |          >   | W2
 *      +---------------  */
void rooms_make_corner(Rooms *fixture, double length, double width, double w1, double w2, bool mirrored);

/* Two rooms side by side, 3 m by 3 m each, a door between them in the wall "w2", and the exit in the second one. */
void rooms_make_two(Rooms *fixture, double width, double door, int state);

/* Builds the outline and the free space again, after rooms_free, once the plan has been changed. */
void rooms_build(Rooms *fixture);

/* Turns the house about the origin by `angle` rad, then shifts it. */
void rooms_turn(Rooms *fixture, double angle, Vec2 shift);

/* Returns the least clearance of a profile's body, m, up to ROUTE_CLEARANCE_REACH, along a path and at 99 places
 * between each two of its poses. */
double rooms_clearance_along(const FreeSpace *space, const Profile *profile, const Route *route);

/* Releases either house. */
void rooms_free(Rooms *fixture);

#define ROOMS_FIT_MOST 0.05 /* m */

/* Returns the largest growth on every side, m, up to ROOMS_FIT_MOST, with which the body still gets from the start to
 * an exit. */
double rooms_fit_margin(const Rooms *fixture);

/* Checks that every pose is free, and every motion between poses is along the heading or a turn on the spot. */
void rooms_check_path(const Rooms *fixture, const Route *route);
