/* Plans the route out: whether a body fits, whether a driver can drive it, the path, and otherwise the blockage.
 *
 * There are two kinds of fit (both for the exact rectangle length x width):
 *   fits      any rigid motion of the body: a helper lifts and shifts it;
 *   drivable  the driver's own motion: forwards and backwards along arcs of the drive axle's middle, turns on the spot,
 *             never sideways, with at most `most_reversals` changes of direction.
 * Between the two a manual chair can skid: turn about the body's middle while the drive wheels scrape sideways. Such a
 * way is told, with the length of its skids, but it is not driven.
 *
 * The closed form for `fits` in a right-angle corner, for bodies longer than both corridors are wide: w x l turns from
 * W1 into W2 exactly when l <= min over t in (0, pi/2) of (W1 cos t + W2 sin t - w) / (sin t cos t).
 *
 * A path is proposed by search over (x, y, heading) with the time under the speed law as its cost (hybrid A*; Dolgov,
 * Thrun, Montemerlo and Diebel 2010), made free and then quick by moving its stations (decide.h). It is the quickest
 * that was found; that there is none at all is proved only for a body that does not fit (fit.h). */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "base/vec2.h"
#include "route/fields.h"
#include "space/freespace.h"
#include "plan/plan.h"
#include "plan/profile.h"

/* A pose of the reference point (drive axle) on a path. */
typedef struct Pose {
    Vec2 at;          /* m */
    double heading;   /* rad */
    double clearance; /* m, clearance of the exact rectangle, up to ROUTE_CLEARANCE_REACH */
    int direction;    /* direction of the motion that ends here: +1 forwards, -1 backwards, 0 a turn on the spot */
} Pose;

#define ROUTE_CLEARANCE_REACH 0.5 /* m */

#define ROUTE_EASED 0.03 /* m, clearance at the start of a route in the middle of a run */

/* The quantity that a blockage tells: a width between obstacles, or the strength of the driver. */
typedef enum Lack { LACK_WIDTH, LACK_PUSH, LACK_MOMENT } Lack;

/* Place and cause of a missing path. */
typedef struct Blockage {
    Vec2 at;         /* m */
    char what[96];   /* "door d2", "wardrobe (f3)", "start", "exit e1"; furniture before a wall; of a driver who is too
                        weak "start from rest", "turn" or "bend", with its place, "turn at (4.20, 1.05)" */
    double has;      /* m, existing width; 0 if the cause is not a width; or N or N m: strength.h */
    double needs;    /* m: tried for a chair at a door, or else estimated; of a disc, its own width; or N or N m */
    Lack lacks;      /* what `has` and `needs` are */
    bool estimated;  /* True if `needs` is an estimate */
    double skid;     /* m, with which the chair gets out if its drive wheels skid sideways, in all; 0: none is known */
    char beside[96]; /* the other side of a place that furniture narrows, where `what` does not name it */
    bool posed;      /* True if the pose of the chair that sticks there is known: */
    Vec2 middle;     /* m, of its body */
    double heading;  /* rad */
} Blockage;

typedef enum RouteAnswer {
    ROUTE_FOUND,
    ROUTE_CANNOT_PASS, /* the blockage gives the place */
    ROUTE_NO_EXIT,     /* no exit exists or is usable */
    ROUTE_TOO_WEAK, /* there is a way, but not for the driver's strength: the blockage gives the place (strength.h) */
    ROUTE_INTERRUPTED, /* neither yes nor no: the route holds nothing else */
} RouteAnswer;

typedef struct Route {
    RouteAnswer answer;
    bool fits;     /* True if the body fits; known only with ROUTE_FOUND, ROUTE_CANNOT_PASS and ROUTE_TOO_WEAK */
    bool drivable; /* == ROUTE_FOUND */
    int reversals;
    size_t exit; /* exit taken or aimed at */
    Pose *poses; /* (count), about 0.05 m apart or, on the spot, about 5 degrees; owned */
    size_t count;
    double length;     /* m, length of the reference point's path */
    double narrowest;  /* m, least clearance of the exact rectangle along the path (ROUTE_CLEARANCE_REACH: more) */
    Vec2 narrowest_at; /* m, reference point at that place */
    Blockage blockage; /* set when there is no path */
} Route;

/* A request for a route. */
typedef struct RouteQuery {
    const Plan *plan;
    const FreeSpace *space;
    const Profile *profile;
    Vec2 at;         /* m, start of the reference point */
    double heading;  /* rad */
    const Vec2 *via; /* (via_count) points to pass in order, each within half a body's length */
    size_t via_count;
    size_t exit;         /* SIZE_MAX: the quickest usable exit */
    double time;         /* s, start time of the person: exits closed for good by then are not usable */
    double opens_before; /* s: exits that open at that time or later are not usable; 0: they are */
    double pressed;      /* m, > 0 in the middle of a run: largest overlap with an obstacle at the start. The route of a
                            chair that overlaps then begins straight back, or ahead, until it stands ROUTE_EASED clear;
                            where that does not clear it, it begins ROUTE_EASED away from nearby obstacles if there is
                            room, without a turn */
    int most_reversals;
    bool brief; /* True if the blockage of a chair that does not fit is computed only for carrying it: the extra width
                   for driving takes long to find */
    bool any;   /* True if any way will do: the first free one is the answer, which is sooner there than the quickest. A
                   yes or no is the same */
    bool whether; /* True with `any` if only the yes or no matters: a way is the first one that is free, before it gets
                     comfortable, and a missing one has no blockage. A yes has a way that is swept free, also where
                     `any` alone would not have ended with it */
    bool rolls;   /* True if the way must not turn on the spot: what turns in the search has to become a bend. A missing
                     way has no blockage */
    const Stop *stop;         /* requested: end with ROUTE_INTERRUPTED; NULL: never */
    Fields *fields;           /* cache shared with other queries; NULL: none, with the same result */
    struct Recall *recall;    /* answers of other houses, which may still hold (recall.h); NULL: none, with the same
                                 result */
    const FreeSpace *watched; /* of which `space` is a copy that notes what is read; NULL: it is none */
    const FieldBars *bars;    /* where the search is not led (settle.c), with which nothing is recalled; NULL: none */
    Reads *times;             /* (via_count + 1) with `watched`: notes which times to each goal are read */
} RouteQuery;

enum { ROUTE_WIDTHS = 160 /* characters that route_widths needs at most */ };

/* Returns "m", "N" or "N m". */
const char *route_lack_unit(Lack lacks);

/* Writes "needs at least 0.80 m, has 0.75 m", or "needs about 0.80 m, has 0.75 m beside wardrobe (f3)" of an estimate,
 * the required width rounded up and the existing one down to a centimetre, or "needs 26 N m, has 2 N m" of a driver who
 * is too weak; "" if the cause is neither. */
void route_widths(const Blockage *blockage, char *text, size_t size);

/* Writes "could pass with skids of 0.15 m in all", rounded up to a centimetre; "" if the chair cannot. */
void route_skids(const Blockage *blockage, char *text, size_t size);

/* Plans the driver's route. route_free releases it. */
Route route_drive(const RouteQuery *query);

/* Plans the route of a round body of radius profile->width / 2 (driving `miura`): poses along the shortest path that
 * keeps its distance, headings along the path, no reversals. */
Route route_round(const RouteQuery *query);

void route_free(Route *route);
