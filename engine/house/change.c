#include "house/change.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/stop.h"
#include "house/observation.h"
#include "house/replan.h"

/* The same people -------------------------------------------------------------------------------------------------- */

void change_init(Change *change, const House *from, const House *to) {
    *change = (Change){.from = from,
                       .to = to,
                       .person_before = memory_zeroed(to->person_count, sizeof(size_t)),
                       .person_after = memory_zeroed(from->person_count, sizeof(size_t)),
                       .door_before = memory_zeroed(to->plan.door_count, sizeof(size_t)),
                       .exit_after = memory_zeroed(from->plan.exit_count, sizeof(size_t))};
    for (size_t i = 0; i < to->person_count; i++)
        change->person_before[i] = house_find_person(from, to->people[i].id);
    for (size_t i = 0; i < from->person_count; i++)
        change->person_after[i] = house_find_person(to, from->people[i].id);
    for (size_t d = 0; d < to->plan.door_count; d++)
        change->door_before[d] = plan_find_door(&from->plan, to->plan.doors[d].id);
    for (size_t e = 0; e < from->plan.exit_count; e++)
        change->exit_after[e] = plan_find_exit(&to->plan, from->plan.exits[e].id);
}

void change_clear(Change *change) {
    memory_free(change->person_before);
    memory_free(change->person_after);
    memory_free(change->door_before);
    memory_free(change->exit_after);
    *change = (Change){0};
}

/* Into the new house ----------------------------------------------------------------------------------------------- */

static double ahead_of(const Profile *profile) {
    return profile->driving == DRIVING_DRIVER ? profile->mass_centre : 0;
}

/* Copies the state of person i, who was `before` in the old world. */
static void carry_over(World *world, const World *old, size_t i, size_t before, const Change *change) {
    const Inhabitant *now = &world->house->people[i], *then = &old->house->people[before];
    double forward = ahead_of(now->profile) - ahead_of(then->profile);
    world->heading[i] = old->heading[before];
    world->axis[i] = old->axis[before];
    world->centre[i] = vec2_along(old->centre[before], forward, world->axis[i]);
    world->velocity[i] = old->velocity[before];
    world->turn[i] = now->profile->driving == DRIVING_DRIVER ? old->turn[before] : 0;
    world->drive[i].plans = old->drive[before].plans;
    world->walk[i] = old->walk[before];
    world->walk[i].door = -1;
    world->walk[i].handle = 0;
    world->phase[i] = old->phase[before];
    world->reason[i] = old->reason[before];
    world->ended[i] = old->ended[before];
    world->start[i] = old->start[before] + (now->delay - then->delay);
    size_t exit = old->exit[before];
    world->exit[i] = exit == SIZE_MAX ? SIZE_MAX : change->exit_after[exit];
}

/* Holds people who now stand inside a solid, so that the contact law does not eject them. */
static void hold_those_inside(World *world) {
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        world->was_clear[i] =
            world_is_clear(world, i) && freespace_distance(&world->house->space, world->centre[i]) >= 0;
        if (world->was_clear[i])
            continue;
        world->velocity[i] = vec2(0, 0);
        world->turn[i] = 0;
    }
}

/* Sets the doors. An opened door stays open, and a door that is new, or was not shut, is open while a person stands
 * where its leaf would be. */
static void set_doors(World *world, const World *old, const Change *change) {
    const Plan *plan = &world->house->plan, *then = &old->house->plan;
    world->shut_doors = 0;
    for (size_t d = 0; d < plan->door_count; d++) {
        size_t before = change->door_before[d];
        if (!outline_door_moves(&plan->doors[d]))
            continue;
        bool opened = before != SIZE_MAX && outline_door_moves(&then->doors[before]) && old->door_open[before];
        bool shuts = world_leaf_is_free(world, d, PRESENT_SHUT);
        world->door_open[d] = !shuts || (opened && world_leaf_is_free(world, d, PRESENT_OPEN));
        world->shut_doors += !world->door_open[d];
    }
}

/* Creates the world in the new house, with all people placed. */
static World go_over(const World *old, const Change *change, const bool *part) {
    const House *house = change->to;
    World world = world_place(house, part);
    world.team = old->team;
    world.clock = old->clock;
    world.decision_steps = old->decision_steps;
    world.sense_steps = old->sense_steps;
    world.digest = old->digest;
    world.door_changes = old->door_changes + 1;
    world.departures = old->departures;
    world.resumed = old->resumed;
    world.wall_crossings = old->wall_crossings;
    world.bounds = box_include(box_include(world.bounds, old->bounds.low), old->bounds.high);
    for (size_t i = 0; i < house->person_count; i++) {
        size_t before = change->person_before[i];
        if (part[i] && before != SIZE_MAX && old->phase[before] != PHASE_ABSENT)
            carry_over(&world, old, i, before, change);
        else
            world.start[i] += clock_time(&old->clock);
    }
    world_list_present(&world);
    set_doors(&world, old, change);
    hold_those_inside(&world);
    return world;
}

/* Ways ------------------------------------------------------------------------------------------------------------- */

/* Returns the index of the next of the route's points if the person is still on the route of that name. */
static size_t via_of(const World *world, const World *old, size_t i, const Change *change) {
    size_t before = change->person_before[i];
    if (before == SIZE_MAX || old->phase[before] == PHASE_ABSENT)
        return 0;
    const PlanRoute *now = world->house->people[i].route, *then = old->house->people[before].route;
    if (!now || !then || strcmp(now->id, then->id) != 0)
        return 0;
    size_t next = replan_next_point(old, before);
    return next < now->via.count ? next : now->via.count;
}

/* Explains a walker inside a wall, who may still have a path from a place next to the wall. */
static void tell_held(const World *world, size_t i, Journey *journey) {
    Route *route = &journey->route;
    if (world->was_clear[i] || world_rides(world, i) || route->answer != ROUTE_FOUND)
        return;
    char name[sizeof route->blockage.what - sizeof "start, inside "];
    outline_place_name(&world->house->outline, &world->house->plan, world->centre[i], name, sizeof name);
    route->answer = ROUTE_CANNOT_PASS;
    route->drivable = false;
    route->blockage = (Blockage){.at = world->centre[i]};
    snprintf(route->blockage.what, sizeof route->blockage.what, "start, inside %s", name);
}

void change_world(World *world, Journeys *journeys, const Change *change, const bool *part, int jobs,
                  const Stop *stop) {
    World next = go_over(world, change, part);
    Whereabouts *places = memory_zeroed(next.present_count, sizeof *places);
    size_t count = 0;
    for (size_t p = 0; p < next.present_count; p++) {
        size_t i = next.present[p];
        if (next.reason[i] != REASON_DIVERGED)
            places[count++] = (Whereabouts){i, world_reference(&next, i), next.heading[i],
                                            via_of(&next, world, i, change), next.start[i]};
    }
    bool brief = journeys->brief;
    world_destroy(world);
    journey_free_all(journeys);
    *journeys = journey_plan_from(change->to, places, count, clock_time(&next.clock), brief, jobs, stop);
    world_begin(&next, journeys->of);
    for (size_t k = 0; k < count; k++) {
        size_t i = places[k].person;
        tell_held(&next, i, &journeys->of[i]);
        replan_set_out(&next, i, false);
    }
    memory_free(places);
    *world = next;
}
