#include "house/world.h"

#include <stdint.h>
#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/real.h"

/* m, distance outside the house beyond which a person counts as thrown out. */
static const double FARTHEST_OUT = 10;

/* Lays `count` elements of `size` bytes into the block at `*used` and returns their address. */
static void *lay(char *block, size_t *used, size_t count, size_t size) {
    size_t place = (*used + 63) / 64 * 64; /* aligned to a cache line */
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
    world->drive[i].heeded = world->drive[i].free_way = HUGE_VAL;
    world->walk[i] = (Walk){.best = HUGE_VAL, .door = -1};
}

/* Who is there --------------------------------------------------------------------------------------------------------
 */

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

/* Doors and walls -----------------------------------------------------------------------------------------------------
 */

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

/* Clips the segment to the core's strip in one direction. Returns false when nothing is left. */
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

/* Beginning and end ---------------------------------------------------------------------------------------------------
 */

/* Returns the number of steps in a time, s, at least one. */
static uint64_t steps_in(double seconds, double dt) {
    return seconds > 1.5 * dt ? (uint64_t)(seconds / dt + 0.5) : 1;
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

/* A driver who starts off the planned line aims from there. */
static void begin_aim(World *world, size_t i) {
    const Track *track = &world->journeys[i].track;
    const Profile *profile = world->house->people[i].profile;
    if (!world->house->driver || profile->driving != DRIVING_DRIVER || !track->count || track->points[0].direction < 0)
        return;
    const TrackPoint *begin = &track->points[0];
    Drive *drive = &world->drive[i];
    drive->aimed = track->points[0].direction;
    drive->axle = vec2_cross(vec2_heading(begin->heading), vec2_sub(world_reference(world, i), begin->at));
    drive->aim =
        drive->axle + (profile->length - profile->axle) * real_sin(vec2_wrap_angle(world->heading[i] - begin->heading));
}

void world_begin(World *world, const Journey *journeys) {
    world->journeys = journeys;
    for (size_t i = 0; i < world->count; i++)
        begin_aim(world, i);
    world_list_present(world);
    walkers_init(&world->walkers, world);
    ride_init(&world->rides, world);
    walkers_update(world);
    ride_list(world);
    ride_gather_forces(world, true); /* the senses before the first step */
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
