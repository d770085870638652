/* The way out: does a body fit, can a driver drive it, along which path, and if not, where does it stick?
 *
 * Two answers to "does it fit" (both on the exact rectangle length x width):
 *   fits      any rigid motion of the body: a helper lifts and shifts it;
 *   drivable  the driver's own motion: forwards and backwards along arcs of the drive axle's middle, turns on the spot,
 *             never sideways, with at most `most_reversals` changes of direction.
 *
 * The closed form for `fits` in a right-angle corner, for bodies longer than both corridors are wide: w x l turns from
 * W1 into W2 exactly when l <= min over t in (0, pi/2) of (W1 cos t + W2 sin t - w) / (sin t cos t).
 *
 * A path is planned by search over (x, y, heading) with the time under the speed law as its cost (hybrid A*; Dolgov,
 * Thrun, Montemerlo and Diebel 2010), then smoothed and swept again. */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "route/fields.h"
#include "space/freespace.h"
#include "plan/plan.h"
#include "plan/profile.h"

/* One pose on a path: of the reference point (drive axle). */
typedef struct Pose {
    Vec2 at;          /* m */
    double heading;   /* rad */
    double clearance; /* m, of the exact rectangle here, up to ROUTE_CLEARANCE_REACH */
    int direction;    /* of the motion that arrives here: +1 forwards, -1 backwards, 0 a turn on the spot */
} Pose;

#define ROUTE_CLEARANCE_REACH 0.5 /* m */

#define ROUTE_EASED 0.03 /* m, of clearance at the start of a route in the middle of a run */

/* Where and why there is no way. */
typedef struct Blockage {
    Vec2 at;       /* m */
    char what[96]; /* "door d2", "wardrobe (f3)", "start", "exit e1" */
    double has;    /* m, the width that is there; 0 where a width makes no sense */
    double needs;  /* m, the width that would do */
} Blockage;

typedef enum RouteAnswer {
    ROUTE_FOUND,
    ROUTE_CANNOT_PASS, /* blockage says where */
    ROUTE_NO_EXIT,     /* there is none, or none is usable */
} RouteAnswer;

typedef struct Route {
    RouteAnswer answer;
    bool fits;     /* meaningful for all but ROUTE_NO_EXIT */
    bool drivable; /* == ROUTE_FOUND */
    int reversals;
    size_t exit; /* taken or aimed at */
    Pose *poses; /* (count), about 0.05 m apart or, on the spot, about 5 degrees; owned */
    size_t count;
    double length;     /* m, of the reference point's path */
    double narrowest;  /* m, the least clearance of the exact rectangle along the path (ROUTE_CLEARANCE_REACH: more) */
    Vec2 narrowest_at; /* m, the reference point there */
    Blockage blockage; /* when there is no way */
} Route;

/* What is asked: from where, for whom, to which exit. */
typedef struct RouteQuery {
    const Plan *plan;
    const FreeSpace *space;
    const Profile *profile;
    Vec2 at;         /* m, the reference point */
    double heading;  /* rad */
    const Vec2 *via; /* (via_count) points to pass within half a body's length, in order */
    size_t via_count;
    size_t exit;     /* SIZE_MAX: the quickest of those usable */
    double time;     /* s, when the person starts: exits closed for good by then are not usable */
    bool open_first; /* nor those that open only later, where another one is open */
    double pressed;  /* m, > 0 in the middle of a run: by how much the body may press on something. The route of a
                        chair then begins ROUTE_EASED off what it is close to, where there is room, without a turn */
    int most_reversals;
    bool brief; /* where a chair cannot pass, the blockage is that of carrying it: what driving needs beyond that, which
                   takes long to find out, is not asked */
    const volatile sig_atomic_t *stop; /* set: give up, whatever the answer; NULL: never */
    Fields *fields;                    /* shared with other queries; NULL: none, the answer is the same */
} RouteQuery;

/* "needs at least 0.80 m, has 0.75 m", what is needed rounded up and what is there down to a centimetre; "" where it is
 * not the width that stops somebody. At least: behind the tightest place there may be another. */
void route_widths(const Blockage *blockage, char *text, size_t size);

/* The driver's route. route_free releases it. */
Route route_drive(const RouteQuery *query);

/* The route of a round body of radius profile->width / 2 (driving `miura`): poses along the shortest path that keeps
 * its distance, headings along the path, no reversals. */
Route route_round(const RouteQuery *query);

void route_free(Route *route);
