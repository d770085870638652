#include "house/ride.h"

#include <string.h>

#include "base/memory.h"
#include "house/touch.h"
#include "house/world.h"
#include "house/yield.h"

void ride_init(Rides *rides, const World *world) {
    *rides = (Rides){0};
    for (size_t i = 0; i < world->count; i++) {
        rides->widest = real_max(rides->widest, world->body[i].swing + world->body[i].radius);
        rides->sight = real_max(rides->sight, world->body[i].sight);
    }
}

void ride_copy(Rides *to, const Rides *from) {
    *to = *from;
    to->pairs = memory_zeroed(from->capacity, sizeof *to->pairs);
    if (from->count)
        memcpy(to->pairs, from->pairs, from->count * sizeof *to->pairs);
    to->old = NULL; /* only used while lists are built */
    to->old_capacity = 0;
}

void ride_clear(Rides *rides) {
    memory_free(rides->pairs);
    memory_free(rides->old);
    *rides = (Rides){0};
}

/* Lists -------------------------------------------------------------------------------------------------------------*/

/* True if the pair may touch before the lists are rebuilt. People behind walls are neither seen nor felt. */
static bool may_touch(const World *world, size_t i, size_t j) {
    const Body *a = &world->body[i], *b = &world->body[j];
    double near = a->swing + a->radius + b->swing + b->radius + real_max(a->sight, b->sight) + WALKERS_SKIN;
    return vec2_distance(world->centre[i], world->centre[j]) < near && yield_sees(world, i, j);
}

/* Copies the springs of a pair from the previous lists, which are sorted by a. */
static void take_over_slips(const Rides *rides, size_t old_count, RidePair *pair) {
    size_t low = 0, high = old_count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (rides->old[middle].a < pair->a)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < old_count && rides->old[low].a == pair->a; low++)
        if (rides->old[low].b == pair->b) {
            *pair = rides->old[low];
            return;
        }
}

static void list_rider(World *world, size_t i, size_t old_count) {
    Rides *rides = &world->rides;
    const CellGrid *grid = &world->walkers.cells;
    double reach = world->body[i].swing + world->body[i].radius + rides->widest + rides->sight + WALKERS_SKIN;
    CellRange range = cell_grid_around(grid, world->centre[i], reach);
    for (int y = range.y0; y <= range.y1; y++) {
        uint32_t end;
        for (uint32_t s = cell_grid_row(grid, &range, y, &end); s < end; s++) {
            uint32_t j = grid->who[s];
            if (j == i || (world_rides(world, j) && j < i) || !may_touch(world, i, j))
                continue;
            rides->pairs = memory_reserve(rides->pairs, &rides->capacity, rides->count + 1, sizeof *rides->pairs);
            RidePair *pair = &rides->pairs[rides->count++];
            *pair = (RidePair){.a = (uint32_t)i, .b = j};
            take_over_slips(rides, old_count, pair);
        }
    }
}

void ride_list(World *world) {
    Rides *rides = &world->rides;
    RidePair *pairs = rides->pairs;
    size_t capacity = rides->capacity, old_count = rides->count;
    rides->pairs = rides->old;
    rides->capacity = rides->old_capacity;
    rides->old = pairs;
    rides->old_capacity = capacity;
    rides->count = 0;
    for (size_t r = 0; r < world->rider_count; r++)
        list_rider(world, world->riders[r], old_count);
}

/* Forces ------------------------------------------------------------------------------------------------------------*/

/* True if obstacles push the body through its personal space: a driver's steers instead (drive.c). Between people it
 * pushes in every model: a crowd makes way for those who press. */
static bool is_pushed(const World *world, size_t i) {
    return world->house->people[i].profile->driving != DRIVING_DRIVER || house_ring(world->house) == RING_PUSHES;
}

/* 1: normals whose product is nearer to 1 are one direction. */
static const double FLUSH = 1e-6;

/* Notes on which side of the body a gap ahead of the axle is. */
static void feel_side(Sense *sense, const Profile *profile, const Gap *gap, Vec2 axis) {
    if (vec2_dot(gap->arm, axis) + profile->mass_centre < 0)
        return;
    double *side = vec2_cross(axis, gap->arm) > 0 ? &sense->left : &sense->right;
    *side = real_min(*side, gap->gap);
}

/* Returns where the blow of a contact that begins is: in the middle of all that begin in this step along its normal, so
 * that an edge which meets a wall flush is stopped as a whole and not turned about one of its corners. */
static Vec2 middle_of_blow(const Gap *gaps, const bool *begins, size_t count, size_t which) {
    Vec2 sum = {0, 0};
    double share = 0;
    for (size_t g = 0; g < count; g++)
        if (begins[g] && vec2_dot(gaps[g].normal, gaps[which].normal) > 1 - FLUSH) {
            sum = vec2_add(sum, gaps[g].arm);
            share++;
        }
    return vec2_scale(sum, 1 / share);
}

/* Adds F2: body and personal space against walls, furniture and leaves. */
static void force_of_obstacles(World *world, size_t i) {
    const House *house = world->house;
    const Profile *profile = house->people[i].profile;
    Body *body = &world->body[i];
    Vec2 centre = world->centre[i];
    size_t seat = world->seat[i];
    neighbour_list_update(&world->neighbours[seat], body, centre, world->axis[i], &house->outline, &house->plan,
                          world->door_open, world->door_changes);
    Gap gaps[GAPS_MOST];
    Slip kept[GAPS_MOST], *slips = world->slips + seat * GAPS_MOST;
    int held[GAPS_MOST];
    size_t held_count = 0;
    for (int k = 0; k < world->slip_count[seat]; k++)
        if (slips[k].touches)
            held[held_count++] = slips[k].key;
    size_t count = gap_to_obstacles(gaps, body, centre, world->axis[i], &world->neighbours[seat], held, held_count);
    Vec2 force = {0, 0}, rings = {0, 0};
    double moment = 0, ring_moment = 0, rates[GAPS_MOST];
    bool begins[GAPS_MOST];
    bool pushes = is_pushed(world, i);
    for (size_t g = 0; g < count; g++) {
        const Gap *gap = &gaps[g];
        const Slip *before = gap_find_slip(slips, world->slip_count[seat], gap->key);
        kept[g] = before ? *before : (Slip){.key = gap->key};
        Vec2 moving = vec2_along(world->velocity[i], world->turn[i], vec2_left(gap->arm));
        double rate = vec2_dot(moving, gap->normal), sliding = vec2_dot(moving, vec2_left(gap->normal));
        double hard = 0, soft = 0;
        Vec2 ring = gap_force(&profile->space, gap, gap->gap - body->reach, rate, sliding, world->clock.dt,
                              &kept[g].ring, &soft);
        Vec2 both = gap_force(&profile->contact, gap, gap->gap, rate, sliding, world->clock.dt, &kept[g].body, &hard);
        if (pushes) {
            both = vec2_add(ring, both);
            rings = vec2_add(rings, ring);
            ring_moment += vec2_cross(gap->arm, ring);
        }
        kept[g].touches = gap->gap < 0;
        begins[g] = kept[g].touches && !(before && before->touches);
        rates[g] = rate;
        force = vec2_add(force, both);
        moment += vec2_cross(gap->arm, both);
        feel_side(&world->sense[i], profile, gap, world->axis[i]);
        world_feel(&world->sense[i], gap->gap, body->reach, hard, soft, vec2_add(centre, gap->arm), -1);
    }
    for (size_t g = 0; g < count; g++)
        if (begins[g])
            touch_begin(&world->sense[i], profile, world->axis[i], middle_of_blow(gaps, begins, count, g),
                        gaps[g].normal, rates[g], HUGE_VAL);
    memcpy(slips, kept, count * sizeof *kept);
    world->slip_count[seat] = (int)count;
    world->force[i] = vec2_add(world->force[i], force);
    world->moment[i] += moment;
    world->ring[i] = rings;
    world->ring_moment[i] = ring_moment;
}

/* Adds F1 between two people. The larger personal space counts, the law is the mean of both, the forces are equal and
 * opposite. */
static void force_of_pair(World *world, RidePair *pair, bool senses) {
    size_t i = pair->a, j = pair->b;
    const Profile *a = world->house->people[i].profile, *b = world->house->people[j].profile;
    const Body *body_a = &world->body[i], *body_b = &world->body[j];
    double reach = real_max(body_a->reach, body_b->reach), sight = real_max(body_a->sight, body_b->sight);
    double apart = vec2_distance(world->centre[i], world->centre[j]);
    int count_before = pair->slip_count;
    pair->slip_count = 0;
    if (apart > body_a->swing + body_a->radius + body_b->swing + body_b->radius + sight)
        return;
    ContactLaw contact = contact_mean(&a->contact, &b->contact), space = contact_mean(&a->space, &b->space);
    Slip before[RIDE_SLIPS];
    memcpy(before, pair->slips, sizeof before);
    Gap gaps[GAPS_MOST];
    size_t count =
        gap_to_body(gaps, body_a, world->centre[i], world->axis[i], body_b, world->centre[j], world->axis[j], sight);
    Vec2 total = {0, 0};
    for (size_t g = 0; g < count; g++) {
        const Gap *gap = &gaps[g];
        Vec2 arm_b = vec2_sub(vec2_add(world->centre[i], gap->arm), world->centre[j]);
        Vec2 moving = vec2_sub(vec2_along(world->velocity[i], world->turn[i], vec2_left(gap->arm)),
                               vec2_along(world->velocity[j], world->turn[j], vec2_left(arm_b)));
        double rate = vec2_dot(moving, gap->normal), sliding = vec2_dot(moving, vec2_left(gap->normal));
        double hard = 0, soft = 0;
        const Slip *known = gap_find_slip(before, count_before, gap->key);
        Slip slip = known ? *known : (Slip){.key = gap->key};
        Vec2 ring = gap_force(&space, gap, gap->gap - reach, rate, sliding, world->clock.dt, &slip.ring, &soft);
        Vec2 both =
            vec2_add(ring, gap_force(&contact, gap, gap->gap, rate, sliding, world->clock.dt, &slip.body, &hard));
        slip.touches = gap->gap < 0;
        if (slip.touches && !(known && known->touches)) {
            double mass_a = touch_mass(a, world->axis[i], gap->arm, gap->normal);
            double mass_b = touch_mass(b, world->axis[j], arm_b, gap->normal);
            touch_begin(&world->sense[i], a, world->axis[i], gap->arm, gap->normal, rate, mass_b);
            if (world_rides(world, j))
                touch_begin(&world->sense[j], b, world->axis[j], arm_b, gap->normal, rate, mass_a);
        }
        if (pair->slip_count < RIDE_SLIPS)
            pair->slips[pair->slip_count++] = slip;
        total = vec2_add(total, both);
        world->moment[i] += vec2_cross(gap->arm, both);
        world->moment[j] -= vec2_cross(arm_b, both);
        Vec2 at = vec2_add(world->centre[i], gap->arm);
        world_feel(&world->sense[i], gap->gap, body_a->reach, hard, soft, at, (int)j);
        if (senses || world_rides(world, j))
            world_feel(&world->sense[j], gap->gap, body_b->reach, hard, soft, at, (int)i);
    }
    world->force[i] = vec2_add(world->force[i], total);
    if (world_rides(world, j)) {
        world->force[j] = vec2_sub(world->force[j], total);
    } else {
        Vec2 *push = &world->walkers.push[world->walkers.slot_of[j]];
        *push = vec2_sub(*push, total);
    }
}

void ride_gather_forces(World *world, bool senses) {
    Rides *rides = &world->rides;
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        world->force[i] = vec2(0, 0);
        world->moment[i] = 0;
        double reach = world->body[i].reach;
        world->sense[i] = (Sense){.clearance = world->body[i].sight, .left = reach, .right = reach, .other = -1};
        if (world->was_clear[i])
            force_of_obstacles(world, i);
    }
    for (size_t p = 0; p < rides->count; p++)
        if (!world_rides(world, rides->pairs[p].b))
            world->walkers.push[world->walkers.slot_of[rides->pairs[p].b]] = vec2(0, 0);
    for (size_t p = 0; p < rides->count; p++)
        force_of_pair(world, &rides->pairs[p], senses);
}
