#include "house/world.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "house/drive.h"
#include "house/observation.h"

/* m: nobody is pushed farther out of the house. */
static const double FARTHEST_OUT = 10;

/* Layout -------------------------------------------------------------------------------------------------------- */

/* Lays `count` elements of `size` bytes into the block at `*used` and returns where. */
static void *lay(char *block, size_t *used, size_t count, size_t size) {
    size_t place = (*used + 63) / 64 * 64; /* a cache line each */
    *used = place + count * size;
    return block ? block + place : NULL;
}

/* Points the arrays into the block; returns its size. */
static size_t lay_out(World *world, char *block) {
    size_t used = 0, n = world->count, chairs = 0;
    for (size_t i = 0; i < n; i++)
        chairs += world_rides(world, i);
#define LAY(array, count_) world->array = lay(block, &used, count_, sizeof *world->array)
    LAY(centre, n);
    LAY(axis, n);
    LAY(heading, n);
    LAY(velocity, n);
    LAY(turn, n);
    LAY(force, n);
    LAY(ring, n);
    LAY(ring_moment, n);
    LAY(moment, n);
    LAY(drive, n);
    LAY(walk, n);
    LAY(present, n);
    LAY(riders, n);
    LAY(seat, n);
    LAY(phase, n);
    LAY(reason, n);
    LAY(exit, n);
    LAY(ended, n);
    LAY(start, n);
    LAY(sense, n);
    LAY(body, n);
    LAY(was_clear, n);
    LAY(door_open, world->house->plan.door_count);
    LAY(neighbours, chairs);
    LAY(slips, chairs * GAPS_MOST);
    LAY(slip_count, chairs);
#undef LAY
    return used;
}

static void place_person(World *world, size_t i, bool takes_part) {
    const Inhabitant *person = &world->house->people[i];
    const Profile *profile = person->profile;
    double ahead = profile->driving == DRIVING_DRIVER ? profile->mass_centre : 0;
    world->body[i] = body_of(profile);
    world->heading[i] = person->heading;
    world->axis[i] = vec2_heading(person->heading);
    world->centre[i] = vec2_along(person->at, ahead, world->axis[i]);
    world->exit[i] = SIZE_MAX;
    world->start[i] = person->delay;
    world->phase[i] = takes_part ? PHASE_WAITING : PHASE_ABSENT;
    world->drive[i].best_turn = HUGE_VAL;
    world->drive[i].retreat_to = -1;
    world->drive[i].heeded = HUGE_VAL;
    world->walk[i] = (Walk){.best = HUGE_VAL, .door = -1};
}

/* Who is there ---------------------------------------------------------------------------------------------------- */

static bool is_there(const World *world, size_t i) {
    return world->phase[i] != PHASE_ABSENT && world->phase[i] != PHASE_OUT;
}

void world_list_present(World *world) {
    world->present_count = world->rider_count = 0;
    for (size_t i = 0; i < world->count; i++) {
        if (!is_there(world, i))
            continue;
        world->present[world->present_count++] = i;
        if (world_rides(world, i))
            world->riders[world->rider_count++] = i;
    }
}

/* Doors ------------------------------------------------------------------------------------------------------------ */

bool world_leaf_is_free(const World *world, size_t door, Presence presence) {
    const Outline *outline = &world->house->outline;
    for (size_t f = 0; f < outline->face_count; f++) {
        const Face *face = &outline->faces[f];
        if (face->door != (int)door || face->presence != (int)presence)
            continue;
        for (size_t p = 0; p < world->present_count; p++) {
            size_t i = world->present[p];
            double body = world->body[i].swing + world->body[i].radius;
            Vec2 nearest = vec2_nearest_on_segment(world->centre[i], face->a, face->b);
            if (vec2_distance(world->centre[i], nearest) < body) {
                Vec2 local = vec2_unturn(vec2_sub(nearest, world->centre[i]), world->axis[i]);
                const Body *b = &world->body[i];
                if (local.x > b->core_low.x - b->radius && local.x < b->core_high.x + b->radius &&
                    local.y > b->core_low.y - b->radius && local.y < b->core_high.y + b->radius)
                    return false;
            }
        }
    }
    return true;
}

/* Whoever has held a shut door's handle for long enough opens it, once there is room for the leaf. */
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
            drive->stalled = 0; /* opening a door is getting on, waiting for its leaf's place is not */
        try_door(world, door, drive->handle);
    }
}

/* Motion ----------------------------------------------------------------------------------------------------------- */

/* Stands still, or the brakes are on: as hard as the driver can push. */
static Effort brake_person(const World *world, size_t i) {
    const Profile *profile = world->house->people[i].profile;
    Vec2 force = vec2_scale(world->velocity[i], -profile->mass / profile->speed_response);
    double size = vec2_length(force), square = profile->radius_of_gyration * profile->radius_of_gyration;
    if (size > profile->push)
        force = vec2_scale(force, profile->push / size);
    double moment = profile->mass * square * world->turn[i] / profile->turn_response;
    return (Effort){force, -real_max(-profile->turning_moment, real_min(profile->turning_moment, moment))};
}

/* F3 and F4 of chairs: everybody decides from the same frozen state. */
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
    } else if (vec2_dot(velocity, velocity) > 1e-4) { /* a disc looks where it goes, once it goes */
        world->axis[i] = vec2_unit(velocity);
        world->heading[i] = atan2(velocity.y, velocity.x);
    }
}

/* Has the reference point crossed the exit's line between two places? */
static bool crosses(const Exit *exit, Vec2 before, Vec2 after) {
    Vec2 line = vec2_sub(exit->to, exit->from), way = vec2_sub(after, before);
    double a = vec2_cross(line, vec2_sub(before, exit->from)), b = vec2_cross(line, vec2_sub(after, exit->from));
    if ((a < 0) == (b < 0))
        return false;
    double turn = vec2_cross(way, line);
    double along = vec2_cross(way, vec2_sub(exit->from, before));
    return turn != 0 && -along / turn >= 0 && -along / turn <= 1;
}

bool world_leave(World *world, size_t i, Vec2 before, Vec2 after) {
    const Plan *plan = &world->house->plan;
    double time = (double)(world->clock.step + 1) * world->clock.dt;
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        if (time >= exit->opens && time <= exit->closes && crosses(exit, before, after)) {
            world->phase[i] = PHASE_OUT;
            world->exit[i] = e;
            world->ended[i] = time;
            return true;
        }
    }
    return false;
}

void world_give_up(World *world, size_t i, int reason) {
    world->phase[i] = PHASE_STUCK;
    world->reason[i] = reason;
    world->ended[i] = clock_time(&world->clock);
    world->drive[i].departures = world->departures;
    world->walk[i].wish = vec2(0, 0);
}

/* Starts those whose delay is over; those for whom there is no way stay where they are. */
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
            world_give_up(world, i, answer == ROUTE_NO_EXIT ? REASON_NO_EXIT : REASON_CANNOT_PASS);
    }
}

/* Blocked by others, on a way that there is? */
static bool tries_again(const World *world, size_t i) {
    return world->phase[i] == PHASE_STUCK && world->reason[i] == REASON_BLOCKED &&
           world->journeys[i].route.answer == ROUTE_FOUND;
}

/* Somebody has left: perhaps there is room now for those who were blocked. */
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

/* Who no longer gets on stays there; of walkers the decision tells (walk.c). */
static void change_phases(World *world) {
    double time = clock_time(&world->clock);
    if (time >= world->next_start)
        start_people(world, time);
    if (world->resumed != world->departures)
        resume_people(world);
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        if (world->phase[i] == PHASE_MOVING && world->drive[i].stalled > world->house->plan.run.patience) {
            bool closed = time > world->house->plan.exits[world->journeys[i].route.exit].closes;
            world_give_up(world, i, closed ? REASON_NO_EXIT : REASON_BLOCKED);
        }
    }
}

/* Beginning and end ------------------------------------------------------------------------------------------------ */

/* Steps in so many seconds, at least one. */
static uint64_t steps_in(double seconds, double dt) {
    return seconds > 1.5 * dt ? (uint64_t)(seconds / dt + 0.5) : 1;
}

/* Lists that no longer hold are made anew. */
static void update_lists(World *world) {
    if (walkers_update(world))
        ride_list(world);
}

World world_place(const House *house, const bool *part) {
    const Plan *plan = &house->plan;
    World world = {.house = house,
                   .clock = {0, plan->run.dt},
                   .count = house->person_count,
                   .decision_steps = steps_in(WALK_PERIOD, plan->run.dt),
                   .sense_steps = steps_in(WORLD_SENSE_PERIOD, plan->run.dt),
                   .bounds = box_expand(house->outline.box, FARTHEST_OUT),
                   .digest = DIGEST_START};
    world.block_size = lay_out(&world, NULL);
    world.block = memory_zeroed(world.block_size, 1);
    lay_out(&world, world.block);
    for (size_t d = 0; d < plan->door_count; d++) {
        world.door_open[d] = !outline_door_moves(&plan->doors[d]);
        world.shut_doors += !world.door_open[d];
    }
    for (size_t e = 0; e < plan->exit_count; e++)
        world.last_opening = real_max(world.last_opening, plan->exits[e].opens);
    size_t seats = 0;
    for (size_t i = 0; i < world.count; i++) {
        place_person(&world, i, !part || part[i]);
        world.was_clear[i] = world_is_clear(&world, i);
        world.seat[i] = world_rides(&world, i) ? seats++ : SIZE_MAX;
        world.sense[i] = (Sense){.clearance = world.body[i].sight, .other = -1};
    }
    return world;
}

void world_begin(World *world, const Journey *journeys) {
    world->journeys = journeys;
    world_list_present(world);
    walkers_init(&world->walkers, world);
    ride_init(&world->rides, world);
    update_lists(world);
    ride_gather_forces(world, true); /* what everybody feels before the first step */
}

World world_create(const House *house, const Journey *journeys, const bool *part) {
    World world = world_place(house, part);
    world_begin(&world, journeys);
    return world;
}

void world_destroy(World *world) {
    walkers_clear(&world->walkers);
    ride_clear(&world->rides);
    memory_free(world->block);
    *world = (World){0};
}

World world_copy(const World *world) {
    World copy = *world;
    copy.team = NULL;
    copy.block = memory_zeroed(world->block_size, 1);
    memcpy(copy.block, world->block, world->block_size);
    lay_out(&copy, copy.block);
    walkers_copy(&copy.walkers, &world->walkers);
    ride_copy(&copy.rides, &world->rides);
    return copy;
}

/* Digest and divergence ---------------------------------------------------------------------------------------------*/

/* Every person's digest is made by itself and the sum taken, so that the order of people does not matter. */
static uint64_t digest_of_riders(const World *world) {
    uint64_t sum = 0;
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        uint64_t digest = digest_pair(digest_pair(0, world->centre[i]), world->velocity[i]);
        sum += digest_mix(digest_mix(digest, world->heading[i]), world->turn[i]);
    }
    return sum;
}

static bool is_sound(const World *world, size_t i) {
    return world_holds(world, world->centre[i]) && isfinite(world->heading[i]) && isfinite(world->turn[i]);
}

/* Clips the segment to the core's strip in one direction; false when nothing is left. */
static bool clip(double from, double to, double low, double high, double *begin, double *end) {
    if (from == to)
        return from > low && from < high;
    double a = (low - from) / (to - from), b = (high - from) / (to - from);
    *begin = real_max(*begin, real_min(a, b));
    *end = real_min(*end, real_max(a, b));
    return *begin < *end;
}

typedef struct Looking {
    const World *world;
    size_t person;
    bool clear;
} Looking;

static bool look_at_face(void *context, int item) {
    Looking *looking = context;
    const World *world = looking->world;
    const Outline *outline = &world->house->outline;
    size_t i = looking->person;
    if ((size_t)item >= outline->face_count)
        return true;
    const Face *face = &outline->faces[item];
    if (face->presence != PRESENT_ALWAYS && world->door_open[face->door] != (face->presence == PRESENT_OPEN))
        return true;
    const Body *body = &world->body[i];
    Vec2 a = vec2_unturn(vec2_sub(face->a, world->centre[i]), world->axis[i]);
    Vec2 b = vec2_unturn(vec2_sub(face->b, world->centre[i]), world->axis[i]);
    double begin = 0, end = 1;
    looking->clear = !(clip(a.x, b.x, body->core_low.x, body->core_high.x, &begin, &end) &&
                       clip(a.y, b.y, body->core_low.y, body->core_high.y, &begin, &end));
    return looking->clear;
}

bool world_is_clear(const World *world, size_t i) {
    Looking looking = {world, i, true};
    broadphase_visit(world->house->outline.broadphase,
                     box_around(world->centre[i], world->body[i].swing + world->body[i].radius), look_at_face,
                     &looking);
    return looking.clear;
}

bool world_goes_on(const World *world) {
    bool left = world->resumed != world->departures; /* somebody has just left: the blocked will try again */
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        int phase = world->phase[i];
        if (phase == PHASE_WAITING || phase == PHASE_MOVING || (left && tries_again(world, i)))
            return true;
    }
    return false;
}

/* Whose numbers are lost stands where it stood: the last good state. */
static void place_back(World *world, size_t i, Vec2 centre, double heading) {
    world->centre[i] = centre;
    world->heading[i] = heading;
    world->axis[i] = vec2_heading(heading);
    world->velocity[i] = vec2(0, 0);
    world->turn[i] = 0;
}

/* Did the mass centre go into a wall? */
static int crossed_faces(const NeighbourList *neighbours, Vec2 before, Vec2 after) {
    int crossed = 0;
    for (int f = 0; f < neighbours->close_faces; f++)
        crossed += neighbour_list_crosses(&neighbours->face[neighbours->close_face[f]], before, after);
    return crossed;
}

/* Every chair moves; whoever crosses an exit is gone. */
static void move_riders(World *world, size_t *diverged) {
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        if (!world->was_clear[i])
            continue;
        Vec2 before = world_reference(world, i), middle = world->centre[i];
        double heading = world->heading[i];
        move_person(world, i);
        world->wall_crossings += crossed_faces(&world->neighbours[world->seat[i]], middle, world->centre[i]);
        if (world->phase[i] == PHASE_MOVING)
            world->departures += world_leave(world, i, before, world_reference(world, i));
        bool sound = is_sound(world, i);
        if (!sound) {
            *diverged = *diverged == SIZE_MAX ? i : *diverged;
            place_back(world, i, middle, heading);
        }
        /* What is deeper than the body's rounding is being pushed out by the contact law. */
        assert(!sound || world->sense[i].body_force > 0 || world_is_clear(world, i));
    }
}

static void forget_senses(World *world) {
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        world->sense[i] = (Sense){.clearance = world->body[i].sight, .other = -1};
    }
}

WorldStatus world_step(World *world, size_t *who) {
    int departures = world->departures;
    size_t diverged = SIZE_MAX;
    world->sensed = (world->clock.step + 1) % world->sense_steps == 0;
    change_phases(world);
    open_doors(world);
    update_lists(world);
    if (world->sensed)
        forget_senses(world);
    ride_gather_forces(world, world->sensed);
    exert_efforts(world);
    uint64_t digest = walkers_step(world, world->sensed, &diverged);
    move_riders(world, &diverged);
    walkers_follow(world);
    digest += digest_of_riders(world);
    if (diverged != SIZE_MAX)
        world_give_up(world, diverged, REASON_DIVERGED);
    if (world->departures != departures)
        world_list_present(world);
    world->clock.step++;
    world->digest = digest_chain(world->digest, digest);
    if (who)
        *who = diverged;
    return diverged == SIZE_MAX ? WORLD_OK : WORLD_DIVERGED;
}
