/* A route as a person follows it: points along the path with the speed that the passage allows.
 *
 * Speed law, in place of the paper's lost regressions: the steering law of human movement (Accot and Zhai 1997),
 *     v_max(W) = min(v_free, (W - w) / b)
 * with W the width of the passage, measured by rays to both sides, w the body's width and b in s. Then
 *     corners     at v_min (miura), or as fast as the lateral acceleration, the turn rate and the driver's moment M
 *                 allow (driver): v^2 k <= a_lat, v k <= turn rate, I v^2 dk/ds <= M / 2 with k the curvature (pace.h);
 *     before      the deceleration length L from v^2 - v_c^2 = 2 a_d L;
 *     after       the initial acceleration a_0.
 *
 * For the driver the points are those of the planned path, but steps that are too short or too sharp to be rolled are
 * turned on the spot, or left out. For the paper's round body they are straight legs and corners: a corner is an arc
 * about the obstacle's convex corner, from the middle of the passage before it (radius W1 / 2) to the middle of the one
 * after it (W2 / 2), and the legs are the common tangents. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "house/house.h"
#include "route/route.h"

#define TRACK_FORESIGHT 1.7 /* m, over which a driver looks how narrow the way is */

typedef struct TrackPoint {
    Vec2 at;           /* m, position of the reference point */
    double heading;    /* rad, of the body (driver) or of the path (miura) */
    double s;          /* m, along the path */
    double curvature;  /* rad/m, turn of the heading per m of the path */
    double bending;    /* rad/m2, change of the curvature per m of the path */
    double speed;      /* m/s, limit */
    double width;      /* m, of the passage here */
    double clearance;  /* m, of the body, up to ROUTE_CLEARANCE_REACH (driver) */
    double left;       /* m, of the part of the body ahead of the axle, up to the reach of the personal space, on */
    double right;      /* its left and on its right (driver, if house_ring is RING_STEERS) */
    double narrow;     /* m, the least clearance from here on over TRACK_FORESIGHT (driver) */
    double room_left;  /* m, from the path to the nearest obstacle on the left, */
    double room_right; /* and on the right */
    int direction;     /* +1 forwards, -1 backwards, 0 a turn on the spot */
    int corner;        /* index of the corner that the point belongs to, or -1 */
    int door;          /* the door whose swing or leaf the body obstructs from here on, or -1 */
    int next_door;     /* index of the first point from here on that has a door, or -1 */
} TrackPoint;

/* A corner in the paper's sense, an arc about `centre`. */
typedef struct TrackCorner {
    Vec2 centre;                  /* m, the obstacle's corner */
    double before, after;         /* m, W1 and W2 */
    double from, to;              /* m, s at its beginning and end */
    double turn;                  /* rad, counter-clockwise positive */
    double radius_in, radius_out; /* m, at its beginning and end */
} TrackCorner;

typedef struct Track {
    TrackPoint *points; /* (count) */
    size_t count;
    TrackCorner *corners; /* (corner_count) */
    size_t corner_count;
    double length; /* m */
    double exit_s; /* m, s where the path crosses the exit's line */
} Track;

/* Both fill in a zeroed track, for a route that has been found; track_free releases it. */
void track_build_driver(Track *track, const House *house, const Inhabitant *person, const Route *route);
void track_build_miura(Track *track, const House *house, const Inhabitant *person, const Route *route);

/* Returns about how long the way takes to the exit's line, s, with the wait for doors, without other people. */
double track_time(const Track *track, const Plan *plan, const Profile *profile);

void track_free(Track *track);
