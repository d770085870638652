#include "route/strength.h"

#include <math.h>
#include <stdio.h>

#include "base/memory.h"
#include "route/pace.h"

/* Assumed: strength.h. */
#define RUN_UP 0.5      /* m, d */
#define BEND_SPEED 0.03 /* m/s, u */
#define BEND_WAY 0.2    /* m, l */

#define STRAIGHT 0.1 /* rad/m: less curvature is none */

static double inertia(const Profile *profile) {
    double gyration = profile->radius_of_gyration, ahead = profile->mass_centre;
    return profile->mass * (gyration * gyration + ahead * ahead);
}

static double push_from_rest(const Profile *profile) {
    double creep = profile->creep;
    return profile->mass * creep * creep / (2 * RUN_UP);
}

static double moment_in_bend(const Profile *profile, double curvature) {
    return inertia(profile) * BEND_SPEED * BEND_SPEED * curvature / BEND_WAY;
}

void strength_suffice(Profile *profile) {
    double bend = moment_in_bend(profile, pace_sharpest(profile));
    profile->push = fmax(profile->push, push_from_rest(profile) / PACE_TUCKED_PUSH);
    profile->turning_moment = fmax(profile->turning_moment, fmax(pace_spot_moment(profile), bend));
}

/* Notes a place of the way that takes more than there is, if it lacks a greater part of that than those before. */
static void note(Blockage *worst, const Profile *profile, const Pose *pose, const char *what, Lack lacks, double needs,
                 double has) {
    if (has >= needs || (worst->needs > 0 && has * worst->needs >= worst->has * needs))
        return;
    Vec2 ahead = vec2_heading(pose->heading);
    *worst = (Blockage){.at = pose->at,
                        .has = has,
                        .needs = needs,
                        .lacks = lacks,
                        .posed = true,
                        .middle = vec2_along(pose->at, profile->length / 2 - profile->axle, ahead),
                        .heading = pose->heading};
    snprintf(worst->what, sizeof worst->what, "%s at (%.2f, %.2f)", what, pose->at.x, pose->at.y);
}

/* Returns the curvature from a pose on, rad/m, averaged over BEND_WAY or as far as the motion goes. */
static double bend_from(const Route *route, size_t p) {
    double way = 0;
    size_t end = p;
    while (end + 1 < route->count && route->poses[end + 1].direction == route->poses[p + 1].direction &&
           way < BEND_WAY) {
        way += vec2_distance(route->poses[end].at, route->poses[end + 1].at);
        end++;
    }
    double turn = fabs(vec2_wrap_angle(route->poses[end].heading - route->poses[p].heading));
    return way >= BEND_WAY && turn > STRAIGHT * way ? turn / way : 0;
}

void strength_test(Route *route, const Profile *profile, bool round) {
    Blockage worst = {.needs = 0};
    if (route->answer != ROUTE_FOUND)
        return;
    for (size_t p = 0; p + 1 < route->count; p++) {
        const Pose *pose = &route->poses[p], *next = pose + 1;
        double share = pose->clearance < profile->hands ? PACE_TUCKED_PUSH : 1;
        bool from_rest = p == 0 || pose->direction != next->direction;
        if (from_rest && next->direction != 0)
            note(&worst, profile, pose, "start from rest", LACK_PUSH, push_from_rest(profile), share * profile->push);
        if (round)
            continue;
        if (next->direction == 0)
            note(&worst, profile, pose, "turn", LACK_MOMENT, pace_spot_moment(profile), profile->turning_moment);
        else
            note(&worst, profile, pose, "bend", LACK_MOMENT, moment_in_bend(profile, bend_from(route, p)),
                 profile->turning_moment);
    }
    if (!(worst.needs > 0))
        return;
    size_t exit = route->exit;
    route_free(route);
    *route = (Route){.answer = ROUTE_TOO_WEAK, .fits = true, .exit = exit, .blockage = worst};
}

/* Returns the way of somebody as strong as it takes; `rolls`: one without a turn on the spot. */
static Route with_turns(const RouteQuery *query, bool rolls) {
    Profile able = *query->profile;
    RouteQuery other = *query;
    strength_suffice(&able);
    other.profile = &able;
    other.rolls = rolls;
    return route_drive(&other);
}

/* Puts in the place of a way with turns on the spot one that bends where a search with turns does turn, if the driver
 * is strong enough for that. */
static void bend_instead(Route *route, const RouteQuery *query) {
    Route bending = with_turns(query, true);
    strength_test(&bending, query->profile, false);
    if (bending.answer == ROUTE_FOUND || bending.answer == ROUTE_INTERRUPTED) {
        route_free(route);
        *route = bending;
    } else {
        route_free(&bending);
    }
}

Route strength_drive(const RouteQuery *query) {
    RouteQuery whether = *query;
    whether.any = whether.whether = true;
    bool turns = query->profile->turning_moment >= pace_spot_moment(query->profile), bends = turns;
    Route route = turns ? route_drive(query) : route_drive(&whether);
    if (!turns && route.answer != ROUTE_INTERRUPTED && route.answer != ROUTE_NO_EXIT) {
        bends = route.answer == ROUTE_FOUND;
        route_free(&route);
        route = bends ? route_drive(query) : with_turns(query, false);
    }
    strength_test(&route, query->profile, false);
    if (route.answer == ROUTE_TOO_WEAK && !bends)
        bend_instead(&route, query);
    if (route.answer == ROUTE_TOO_WEAK && query->any) { /* the first way takes more than the quickest one */
        RouteQuery quickest = *query;
        quickest.any = false;
        route_free(&route);
        route = strength_drive(&quickest);
    }
    return route;
}

Route strength_round(const RouteQuery *query) {
    Route route = route_round(query);
    strength_test(&route, query->profile, true);
    return route;
}
