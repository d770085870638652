#include "house/phase.h"

#include <math.h>
#include <stdint.h>

#include "house/observation.h"
#include "plan/plan_geometry.h"

/* m: who is held stays this far from the line, so that rounding never carries anybody onto it. */
static const double HOLD_OFF = 1e-3;

static double time_after_step(const World *world) {
    return (double)(world->clock.step + 1) * world->clock.dt;
}

bool phase_hold(const World *world, Vec2 before, Vec2 *after, Vec2 *velocity) {
    const Plan *plan = &world->house->plan;
    double time = time_after_step(world);
    bool held = false;
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        if (!plan_geometry_bars(plan, e, time))
            continue;
        Vec2 along = vec2_unit(vec2_sub(exit->to, exit->from)), motion = vec2_sub(*after, before);
        double across = vec2_cross(along, motion);
        Vec2 ahead = vec2_along(*after, copysign(HOLD_OFF, across), vec2_left(along));
        if (across == 0 || plan_geometry_side(exit, before) == 0 || !plan_geometry_leads_out(exit, before, ahead))
            continue;
        *after = held ? before : vec2_along(before, vec2_dot(motion, along), along); /* held by two: at rest */
        *velocity = held ? vec2(0, 0) : vec2_scale(along, vec2_dot(*velocity, along));
        held = true;
    }
    return held;
}

bool phase_leave(World *world, size_t i, Vec2 before, Vec2 after) {
    const Plan *plan = &world->house->plan;
    double time = time_after_step(world);
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        if (plan_geometry_is_open(exit, time) && plan_geometry_leads_out(exit, before, after)) {
            world->phase[i] = PHASE_OUT;
            world->exit[i] = e;
            world->ended[i] = time;
            return true;
        }
    }
    return false;
}

void phase_give_up(World *world, size_t i, int reason) {
    world->phase[i] = PHASE_STUCK;
    world->reason[i] = reason;
    world->ended[i] = clock_time(&world->clock);
    world->walk[i].wish = vec2(0, 0);
}

/* Starts people whose delay is over; people without a path stay where they are. */
static void start_people(World *world, double time) {
    world->next_start = HUGE_VAL;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        double start = world->start[i];
        RouteAnswer answer = world->journeys[i].route.answer;
        if (world->phase[i] != PHASE_WAITING)
            continue;
        if (time < start) {
            world->next_start = real_min(world->next_start, start);
            continue;
        }
        world->phase[i] = PHASE_MOVING;
        if (answer != ROUTE_FOUND)
            phase_give_up(world, i, observation_reason_of(answer));
    }
}

/* True if the person is blocked by others on an existing path. */
static bool tries_again(const World *world, size_t i) {
    return world->phase[i] == PHASE_STUCK && world->reason[i] == REASON_BLOCKED &&
           world->journeys[i].route.answer == ROUTE_FOUND;
}

/* Lets blocked people try again after a departure, since there may be room now. */
static void resume_people(World *world) {
    world->resumed = world->departures;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        if (!tries_again(world, i))
            continue;
        world->phase[i] = PHASE_MOVING;
        world->reason[i] = REASON_NONE;
        world->drive[i].stalled = world->walk[i].stalled = 0;
    }
}

void phase_update(World *world) {
    double time = clock_time(&world->clock);
    if (time >= world->next_start)
        start_people(world, time);
    if (world->resumed != world->departures)
        resume_people(world);
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        /* A chair that makes room for another one has until that is done. */
        double patience = fmax(world->house->plan.run.patience, world->drive[i].room_by);
        if (world->phase[i] == PHASE_MOVING && world->drive[i].stalled > patience) {
            bool closed = time > world->house->plan.exits[world->journeys[i].route.exit].closes;
            phase_give_up(world, i, closed ? REASON_NO_EXIT : REASON_BLOCKED);
        }
    }
}

bool phase_any_active(const World *world) {
    bool left = world->resumed != world->departures; /* a person has just left: the blocked will try again */
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        int phase = world->phase[i];
        if (phase == PHASE_WAITING || phase == PHASE_MOVING || (left && tries_again(world, i)))
            return true;
    }
    return false;
}
