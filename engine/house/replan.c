#include "house/replan.h"

#include <stdint.h>

#include "base/memory.h"
#include "house/observation.h"

double replan_next(const World *world, double time) {
    double next = HUGE_VAL;
    for (size_t e = 0; e < world->house->plan.exit_count; e++)
        if (world->house->plan.exits[e].closes > time)
            next = fmin(next, world->house->plan.exits[e].closes);
    return next;
}

/* Is the exit that the person aims at, or one of those that it may aim at, closed? */
static bool has_lost_exit(const World *world, size_t i, double time) {
    const Plan *plan = &world->house->plan;
    const Route *route = &world->journeys[i].route;
    if (world->phase[i] != PHASE_WAITING && world->phase[i] != PHASE_MOVING)
        return false;
    if (route->exit != SIZE_MAX)
        return plan->exits[route->exit].closes <= time;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan->exits[e].closes <= time)
            return true;
    return false;
}

/* The next of the route's points: of a chair the one behind the last pose that came near to a point. */
static size_t next_point(const World *world, size_t i) {
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

/* Person i starts on the new journey, or stays where there is none. */
static void set_out(World *world, size_t i) {
    const Route *route = &world->journeys[i].route;
    world->drive[i] = (Drive){.best_turn = HUGE_VAL, .retreat_to = -1, .heeded = HUGE_VAL};
    world->walk[i].leg = 0;
    world->walk[i].best = HUGE_VAL;
    world->walk[i].stalled = 0;
    if (route->answer != ROUTE_FOUND && world->phase[i] == PHASE_MOVING)
        world_give_up(world, i, route->answer == ROUTE_NO_EXIT ? REASON_NO_EXIT : REASON_CANNOT_PASS);
}

void replan_journeys(World *world, Journeys *journeys, int jobs, const volatile sig_atomic_t *stop) {
    double time = clock_time(&world->clock);
    Whereabouts *places = memory_allocate(world->present_count, sizeof *places);
    size_t count = 0;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        if (has_lost_exit(world, i, time))
            places[count++] = (Whereabouts){i, world_reference(world, i), world->heading[i], next_point(world, i)};
    }
    journey_plan_again(journeys, world->house, places, count, time, jobs, stop);
    for (size_t k = 0; k < count; k++)
        set_out(world, places[k].person);
    memory_free(places);
}
