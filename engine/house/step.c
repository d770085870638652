#include "house/step.h"

#include <assert.h>
#include <stdint.h>

#include "base/digest.h"
#include "base/real.h"
#include "house/drive.h"
#include "house/observation.h"
#include "house/phase.h"

/* Doors ---------------------------------------------------------------------------------------------------------------
 */

/* Opens a shut door whose handle has been held for long enough, once there is room for the leaf. */
static void try_door(World *world, int door, double handle) {
    if (handle < world->house->plan.doors[door].opening_time || world->door_open[door] ||
        !world_leaf_is_free(world, (size_t)door, PRESENT_OPEN))
        return;
    world->door_open[door] = true;
    world->door_changes++;
    world->shut_doors--;
}

static void open_doors(World *world) {
    if (!world->shut_doors)
        return;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        if (!world_rides(world, i)) {
            if (world->phase[i] == PHASE_MOVING && world->walk[i].door >= 0)
                try_door(world, world->walk[i].door, world->walk[i].handle);
            continue;
        }
        int door = world->phase[i] == PHASE_MOVING ? drive_door_at_hand(world, i) : -1;
        Drive *drive = &world->drive[i];
        if (door < 0) {
            drive->handle = 0;
            continue;
        }
        drive->handle += world->clock.dt;
        if (drive->handle < world->house->plan.doors[door].opening_time)
            drive->stalled = 0; /* opening a door counts as progress; waiting for space for its leaf does not */
        try_door(world, door, drive->handle);
    }
}

/* Motion --------------------------------------------------------------------------------------------------------------
 */

/* Returns the braking effort of a person who stands: limited by the driver's push. */
static Effort brake_person(const World *world, size_t i) {
    const Profile *profile = world->house->people[i].profile;
    Vec2 force = vec2_scale(world->velocity[i], -profile->mass / profile->speed_response);
    double size = vec2_length(force), square = profile->radius_of_gyration * profile->radius_of_gyration;
    if (size > profile->push)
        force = vec2_scale(force, profile->push / size);
    double moment = profile->mass * square * world->turn[i] / profile->turn_response;
    return (Effort){force, -real_max(-profile->turning_moment, real_min(profile->turning_moment, moment))};
}

/* Adds F3 and F4 of chairs, all decided from the same frozen state. */
static void exert_efforts(World *world) {
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        Effort effort =
            world->phase[i] == PHASE_MOVING ? drive_person(world, i, &world->drive[i]) : brake_person(world, i);
        world->force[i] = vec2_add(world->force[i], effort.force);
        world->moment[i] += effort.moment;
    }
}

static void move_person(World *world, size_t i) {
    const Profile *profile = world->house->people[i].profile;
    bool turns = profile->driving == DRIVING_DRIVER;
    double dt = world->clock.dt, inertia = profile->mass * profile->radius_of_gyration * profile->radius_of_gyration;
    Vec2 velocity = vec2_along(world->velocity[i], dt / profile->mass, world->force[i]);
    double turn = turns ? world->turn[i] + dt / inertia * world->moment[i] : 0;
    if (turns)
        drive_hold_sideways(profile, dt, world->axis[i], &velocity, &turn);
    world->velocity[i] = velocity;
    world->turn[i] = turn;
    world->centre[i] = vec2_along(world->centre[i], dt, velocity);
    if (turns) {
        world->heading[i] = vec2_wrap_angle(world->heading[i] + dt * turn);
        world->axis[i] = vec2_heading(world->heading[i]);
    } else if (vec2_dot(velocity, velocity) > 1e-4) { /* a moving disc faces its direction of motion */
        world->axis[i] = vec2_unit(velocity);
        world->heading[i] = real_atan2(velocity.y, velocity.x);
    }
}

/* Restores the last good position of a person whose numbers have diverged, or who is held by an exit. */
static void place_back(World *world, size_t i, Vec2 centre, double heading) {
    world->centre[i] = centre;
    world->heading[i] = heading;
    world->axis[i] = vec2_heading(heading);
    world->velocity[i] = vec2(0, 0);
    world->turn[i] = 0;
}

/* Counts the faces through which the mass centre has entered a wall. */
static int crossed_faces(const NeighbourList *neighbours, Vec2 before, Vec2 after) {
    int crossed = 0;
    for (int f = 0; f < neighbours->close_faces; f++)
        crossed += neighbour_list_crosses(&neighbours->face[neighbours->close_face[f]], before, after);
    return crossed;
}

static bool is_sound(const World *world, size_t i) {
    return world_holds(world, world->centre[i]) && isfinite(world->heading[i]) && isfinite(world->turn[i]);
}

/* Returns the sum of the persons' digests, so that the order of people does not matter. */
static uint64_t digest_of_riders(const World *world) {
    uint64_t sum = 0;
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        uint64_t digest = digest_pair(digest_pair(0, world->centre[i]), world->velocity[i]);
        sum += digest_mix(digest_mix(digest, world->heading[i]), world->turn[i]);
    }
    return sum;
}

/* Moves every chair; a chair that crosses an exit leaves. */
static void move_riders(World *world, size_t *diverged) {
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        if (!world->was_clear[i])
            continue;
        Vec2 before = world_reference(world, i), middle = world->centre[i];
        double heading = world->heading[i];
        move_person(world, i);
        Vec2 after = world_reference(world, i), velocity = world->velocity[i];
        if (phase_hold(world, before, &after, &velocity)) {
            place_back(world, i, middle, heading);
            world->velocity[i] = velocity;
        }
        world->wall_crossings += crossed_faces(&world->neighbours[world->seat[i]], middle, world->centre[i]);
        if (world->phase[i] == PHASE_MOVING)
            world->departures += phase_leave(world, i, before, world_reference(world, i));
        bool sound = is_sound(world, i);
        if (!sound) {
            *diverged = *diverged == SIZE_MAX ? i : *diverged;
            place_back(world, i, middle, heading);
        }
        /* A body that overlaps by more than its rounding is being pushed out by the contact law. */
        assert(!sound || world->sense[i].body_force > 0 || world_is_clear(world, i));
    }
}

/* The step ------------------------------------------------------------------------------------------------------------
 */

static void forget_senses(World *world) {
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        world->sense[i] = (Sense){.clearance = world->body[i].sight, .other = -1};
    }
}

StepStatus step_world(World *world, size_t *who) {
    int departures = world->departures;
    size_t diverged = SIZE_MAX;
    world->sensed = (world->clock.step + 1) % world->sense_steps == 0;
    phase_update(world);
    open_doors(world);
    if (walkers_update(world))
        ride_list(world);
    if (world->sensed)
        forget_senses(world);
    ride_gather_forces(world, world->sensed);
    exert_efforts(world);
    uint64_t digest = walkers_step(world, world->sensed, &diverged);
    move_riders(world, &diverged);
    walkers_sync_chairs(world);
    digest += digest_of_riders(world);
    if (diverged != SIZE_MAX)
        phase_give_up(world, diverged, REASON_DIVERGED);
    if (world->departures != departures)
        world_list_present(world);
    world->clock.step++;
    world->digest = digest_chain(world->digest, digest);
    if (who)
        *who = diverged;
    return diverged == SIZE_MAX ? STEP_OK : STEP_DIVERGED;
}
