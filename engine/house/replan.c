#include "house/replan.h"

#include <stdint.h>

#include "base/memory.h"
#include "base/stop.h"
#include "house/closed.h"
#include "house/observation.h"
#include "house/phase.h"
#include "route/pace.h"
#include "route/search.h"

double replan_next(const World *world, double time) {
    double next = HUGE_VAL;
    for (size_t e = 0; e < world->house->plan.exit_count; e++)
        if (world->house->plan.exits[e].closes > time)
            next = fmin(next, world->house->plan.exits[e].closes);
    return next;
}

/* True if the rest of a person's way crosses a line that is closed now. */
static bool is_barred_ahead(const World *world, size_t i) {
    const Plan *plan = &world->house->plan;
    const Journey *journey = &world->journeys[i];
    double time = clock_time(&world->clock);
    bool barred = closed_on_track(plan, time, &journey->track, world->drive[i].index);
    for (size_t leg = (size_t)world->walk[i].leg; leg < journey->leg_count && !barred; leg++)
        barred = closed_on_field(plan, journey->since, time, journey->legs[leg]);
    return barred;
}

/* True if the person's exit has closed or the way there is barred; of who may take any exit, if one has closed. */
static bool has_lost_exit(const World *world, size_t i) {
    const Plan *plan = &world->house->plan;
    double time = clock_time(&world->clock);
    const Route *route = &world->journeys[i].route;
    bool blocked = world->phase[i] == PHASE_STUCK && world->reason[i] == REASON_BLOCKED;
    if (world->phase[i] != PHASE_WAITING && world->phase[i] != PHASE_MOVING && !blocked)
        return false;
    if (route->exit != SIZE_MAX)
        return plan->exits[route->exit].closes <= time || is_barred_ahead(world, i);
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan->exits[e].closes <= time)
            return true;
    return false;
}

/* For a chair the next point follows the last pose that came near to a point. */
size_t replan_next_point(const World *world, size_t i) {
    const PlanRoute *route = world->house->people[i].route;
    const Journey *journey = &world->journeys[i];
    size_t count = route ? route->via.count : 0, next = journey->via;
    if (!world_rides(world, i))
        return next + (size_t)world->walk[i].leg;
    for (size_t p = 0; p <= world->drive[i].index && p < journey->track.count && next < count; p++)
        if (vec2_distance(journey->track.points[p].at, route->via.at[next]) <
            world->house->people[i].profile->length / 2)
            next++;
    return next;
}

void replan_set_out(World *world, size_t i, bool strayed) {
    RouteAnswer answer = world->journeys[i].route.answer;
    Drive *drive = &world->drive[i];
    if (world->journeys[i].kept) { /* try again */
        drive->stalled = drive->room_by = 0;
        drive->retreats = false;
        drive->retries = 0;
    } else {
        *drive = (Drive){.best_turn = HUGE_VAL,
                         .heeded = HUGE_VAL,
                         .free_way = HUGE_VAL,
                         .gone = drive->gone,
                         .plans = drive->plans};
    }
    drive->plans += strayed;
    world->walk[i].leg = 0;
    world->walk[i].best = HUGE_VAL;
    world->walk[i].stalled = 0;
    if (answer == ROUTE_FOUND && world->phase[i] == PHASE_STUCK) {
        world->phase[i] = PHASE_MOVING;
        world->reason[i] = REASON_NONE;
    } else if (answer != ROUTE_FOUND && world->phase[i] != PHASE_WAITING) {
        phase_give_up(world, i, observation_reason_of(answer));
    }
}

/* Assumed. s: a chair without progress for this long has lost its path, if it is off the path, or is wedged, if it
 * touches something; number: how often a chair is planned again. */
static const double LOST_AFTER = 3, WEDGED_AFTER = 8;
enum { PLANS_MOST = 12, STOPPING_PARTS = 8 };

static bool has_strayed(const World *world, size_t i) {
    const Drive *drive = &world->drive[i];
    bool stuck = world->phase[i] == PHASE_STUCK && world->reason[i] == REASON_BLOCKED;
    if (!world_rides(world, i) || !(stuck || world->phase[i] == PHASE_MOVING) || drive->plans >= PLANS_MOST)
        return false;
    bool off = fabs(drive->offset - drive->aside - drive->axle) > world->house->people[i].profile->width;
    return (off && (stuck || drive->stalled > LOST_AFTER)) ||
           (world->sense[i].body_force > 0 && (stuck || drive->stalled > WEDGED_AFTER));
}

/* Returns where the reference point of a person comes to rest: a chair that turns round at once goes on for as long as
 * it takes to stop, if the way is free. */
static Vec2 resting_place(const World *world, size_t i) {
    const Profile *profile = world->house->people[i].profile;
    Vec2 at = world_reference(world, i), axis = world->axis[i];
    if (profile->driving != DRIVING_DRIVER)
        return at;
    double speed = vec2_dot(world->velocity[i], axis), braking = pace_braking(profile, profile->space_reach);
    Rectangle body = search_body(profile);
    Vec2 rest = vec2_along(at, speed * fabs(speed) / (2 * braking), axis);
    if (closed_between(&world->house->plan, clock_time(&world->clock), at, rest) != SIZE_MAX)
        return at;
    for (int part = 1; part <= STOPPING_PARTS; part++) {
        Vec2 there = vec2_along(at, (double)part / STOPPING_PARTS, vec2_sub(rest, at));
        if (search_clearance(&world->house->space, &body, there, world->heading[i], ROUTE_EASED, NULL) < ROUTE_EASED)
            return at;
    }
    return rest;
}

static void plan_again(World *world, Journeys *journeys, bool strays, int jobs, const Stop *stop) {
    Whereabouts *places = memory_zeroed(world->present_count, sizeof *places);
    size_t count = 0;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        if (strays ? has_strayed(world, i) : has_lost_exit(world, i))
            places[count++] = (Whereabouts){i, strays ? world_reference(world, i) : resting_place(world, i),
                                            world->heading[i], replan_next_point(world, i), world->start[i]};
    }
    if (count)
        journey_plan_again(journeys, world->house, places, count, clock_time(&world->clock), strays, jobs, stop);
    for (size_t k = 0; k < count && !stop_requested(stop); k++)
        replan_set_out(world, places[k].person, strays);
    memory_free(places);
}

void replan_strays(World *world, Journeys *journeys, int jobs, const Stop *stop) {
    plan_again(world, journeys, true, jobs, stop);
}

void replan_journeys(World *world, Journeys *journeys, int jobs, const Stop *stop) {
    plan_again(world, journeys, false, jobs, stop);
}
