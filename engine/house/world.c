#include "house/world.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "house/drive.h"
#include "house/observation.h"
#include "house/yield.h"

/* Layout -------------------------------------------------------------------------------------------------------- */

/* Lays `count` elements of `size` bytes into the block at `*used` and returns where. */
static void *lay(char *block, size_t *used, size_t count, size_t size) {
    size_t place = (*used + 63) / 64 * 64; /* a cache line each */
    *used = place + count * size;
    return block ? block + place : NULL;
}

/* Points the arrays into the block; returns its size. */
static size_t lay_out(World *world, char *block) {
    size_t used = 0, n = world->count;
    world->centre = lay(block, &used, n, sizeof *world->centre);
    world->axis = lay(block, &used, n, sizeof *world->axis);
    world->heading = lay(block, &used, n, sizeof *world->heading);
    world->velocity = lay(block, &used, n, sizeof *world->velocity);
    world->turn = lay(block, &used, n, sizeof *world->turn);
    world->force = lay(block, &used, n, sizeof *world->force);
    world->ring = lay(block, &used, n, sizeof *world->ring);
    world->ring_moment = lay(block, &used, n, sizeof *world->ring_moment);
    world->moment = lay(block, &used, n, sizeof *world->moment);
    world->present = lay(block, &used, n, sizeof *world->present);
    world->phase = lay(block, &used, n, sizeof *world->phase);
    world->reason = lay(block, &used, n, sizeof *world->reason);
    world->exit = lay(block, &used, n, sizeof *world->exit);
    world->ended = lay(block, &used, n, sizeof *world->ended);
    world->sense = lay(block, &used, n, sizeof *world->sense);
    world->drive = lay(block, &used, n, sizeof *world->drive);
    world->body = lay(block, &used, n, sizeof *world->body);
    world->near = lay(block, &used, n, sizeof *world->near);
    world->slips = lay(block, &used, n * GAPS_MOST, sizeof *world->slips);
    world->slip_count = lay(block, &used, n, sizeof *world->slip_count);
    world->pair_slips = lay(block, &used, n * PAIR_SLIPS, sizeof *world->pair_slips);
    world->pair_slip_count = lay(block, &used, n, sizeof *world->pair_slip_count);
    world->was_clear = lay(block, &used, n, sizeof *world->was_clear);
    world->door_open = lay(block, &used, world->house->plan.door_count, sizeof *world->door_open);
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
    world->phase[i] = takes_part ? PHASE_WAITING : PHASE_ABSENT;
    world->drive[i].best_turn = HUGE_VAL;
    world->drive[i].retreat_to = -1;
}

/* Forces ---------------------------------------------------------------------------------------------------------- */

static bool is_there(const World *world, size_t i) {
    return world->phase[i] != PHASE_ABSENT && world->phase[i] != PHASE_OUT;
}

static void list_present(World *world) {
    world->present_count = 0;
    for (size_t i = 0; i < world->count; i++)
        if (is_there(world, i))
            world->present[world->present_count++] = i;
}

/* One law over one gap, of which the body has the share. */
static Vec2 law_force(const ContactLaw *law, const Gap *gap, double compression_gap, double gap_rate, double sliding,
                      double dt, double *slip, double *normal_force) {
    double normal = contact_normal(law, compression_gap, gap_rate) * gap->share;
    *normal_force = normal;
    if (normal <= 0) {
        *slip = 0;
        return vec2(0, 0);
    }
    ContactLaw shared = *law;
    shared.tangential_stiffness *= gap->share;
    shared.tangential_damping *= gap->share;
    double along = contact_tangential(&shared, normal, sliding, dt, slip);
    return vec2_along(vec2_scale(gap->normal, normal), along, vec2_left(gap->normal));
}

static const Slip *find_slip(const Slip *slips, int count, int key) {
    for (int k = 0; k < count; k++)
        if (slips[k].key == key)
            return &slips[k];
    return NULL;
}

static void feel(Sense *sense, const Body *body, const Gap *gap, double body_force, double ring_force, Vec2 at,
                 int other) {
    if (gap->gap < sense->clearance) {
        sense->clearance = gap->gap;
        sense->nearest_at = at;
        sense->other = other;
    }
    sense->ring = real_max(sense->ring, real_min(body->reach, body->reach - gap->gap));
    if (body_force > 0 && body_force >= sense->body_force)
        sense->contact_at = at;
    sense->body_force += body_force;
    sense->ring_force += ring_force;
}

/* F2: body and personal space against walls, furniture and leaves. */
static void force_of_obstacles(World *world, size_t i) {
    const House *house = world->house;
    const Profile *profile = house->people[i].profile;
    Body *body = &world->body[i];
    Vec2 centre = world->centre[i];
    near_update(&world->near[i], body, centre, world->axis[i], &house->outline, &house->plan, world->door_open,
                world->door_changes);
    Gap gaps[GAPS_MOST];
    Slip kept[GAPS_MOST], *slips = world->slips + i * GAPS_MOST;
    int held[GAPS_MOST];
    size_t held_count = 0;
    for (int k = 0; k < world->slip_count[i]; k++)
        if (slips[k].touches)
            held[held_count++] = slips[k].key;
    size_t count = gap_to_obstacles(gaps, body, centre, world->axis[i], &world->near[i], held, held_count);
    Vec2 force = {0, 0}, rings = {0, 0};
    double moment = 0, ring_moment = 0;
    for (size_t g = 0; g < count; g++) {
        const Gap *gap = &gaps[g];
        const Slip *before = find_slip(slips, world->slip_count[i], gap->key);
        kept[g] = before ? *before : (Slip){.key = gap->key};
        Vec2 moving = vec2_along(world->velocity[i], world->turn[i], vec2_left(gap->arm));
        double rate = vec2_dot(moving, gap->normal), sliding = vec2_dot(moving, vec2_left(gap->normal));
        double hard = 0, soft = 0;
        Vec2 ring = law_force(&profile->space, gap, gap->gap - body->reach, rate, sliding, world->clock.dt,
                              &kept[g].ring, &soft);
        Vec2 both = vec2_add(
            ring, law_force(&profile->contact, gap, gap->gap, rate, sliding, world->clock.dt, &kept[g].body, &hard));
        kept[g].touches = gap->gap < 0;
        force = vec2_add(force, both);
        moment += vec2_cross(gap->arm, both);
        rings = vec2_add(rings, ring);
        ring_moment += vec2_cross(gap->arm, ring);
        feel(&world->sense[i], body, gap, hard, soft, vec2_add(centre, gap->arm), -1);
    }
    memcpy(slips, kept, count * sizeof *kept);
    world->slip_count[i] = (int)count;
    world->force[i] = vec2_add(world->force[i], force);
    world->moment[i] += moment;
    world->ring[i] = rings;
    world->ring_moment[i] = ring_moment;
}

static ContactLaw mean_law(const ContactLaw *a, const ContactLaw *b) {
    return (ContactLaw){(a->normal_stiffness + b->normal_stiffness) / 2, (a->normal_damping + b->normal_damping) / 2,
                        (a->tangential_stiffness + b->tangential_stiffness) / 2,
                        (a->tangential_damping + b->tangential_damping) / 2, (a->friction + b->friction) / 2};
}

/* F1: two people. The larger personal space counts, the law is the mean of both, the forces are equal and opposite. */
static void force_of_pair(World *world, size_t i, size_t j, Slip kept[PAIR_SLIPS], int *kept_count) {
    const Profile *a = world->house->people[i].profile, *b = world->house->people[j].profile;
    const Body *body_a = &world->body[i], *body_b = &world->body[j];
    double reach = real_max(body_a->reach, body_b->reach), sight = real_max(body_a->sight, body_b->sight);
    double apart = vec2_distance(world->centre[i], world->centre[j]);
    bool far = apart > body_a->swing + body_a->radius + body_b->swing + body_b->radius + sight;
    if (far || !yield_sees(world, i, j))
        return;
    ContactLaw contact = mean_law(&a->contact, &b->contact), space = mean_law(&a->space, &b->space);
    Gap gaps[GAPS_MOST];
    size_t count =
        gap_to_body(gaps, body_a, world->centre[i], world->axis[i], body_b, world->centre[j], world->axis[j], sight);
    for (size_t g = 0; g < count; g++) {
        const Gap *gap = &gaps[g];
        Vec2 arm_b = vec2_sub(vec2_add(world->centre[i], gap->arm), world->centre[j]);
        Vec2 moving = vec2_sub(vec2_along(world->velocity[i], world->turn[i], vec2_left(gap->arm)),
                               vec2_along(world->velocity[j], world->turn[j], vec2_left(arm_b)));
        double rate = vec2_dot(moving, gap->normal), sliding = vec2_dot(moving, vec2_left(gap->normal));
        double hard = 0, soft = 0;
        int key = (int)j * GAP_PARTS + gap->key;
        const Slip *before = find_slip(world->pair_slips + i * PAIR_SLIPS, world->pair_slip_count[i], key);
        Slip slip = before ? *before : (Slip){.key = key};
        Vec2 ring = law_force(&space, gap, gap->gap - reach, rate, sliding, world->clock.dt, &slip.ring, &soft);
        Vec2 both =
            vec2_add(ring, law_force(&contact, gap, gap->gap, rate, sliding, world->clock.dt, &slip.body, &hard));
        if (*kept_count < PAIR_SLIPS)
            kept[(*kept_count)++] = slip;
        world->force[i] = vec2_add(world->force[i], both);
        world->force[j] = vec2_sub(world->force[j], both);
        world->moment[i] += vec2_cross(gap->arm, both);
        world->moment[j] -= vec2_cross(arm_b, both);
        Vec2 at = vec2_add(world->centre[i], gap->arm);
        feel(&world->sense[i], body_a, gap, hard, soft, at, (int)j);
        feel(&world->sense[j], body_b, gap, hard, soft, at, (int)i);
    }
}

static void gather_forces(World *world) {
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        world->force[i] = vec2(0, 0);
        world->moment[i] = 0;
        world->sense[i] = (Sense){.clearance = world->body[i].sight, .other = -1};
        if (world->was_clear[i])
            force_of_obstacles(world, i);
    }
    for (size_t p = 0; p + 1 < world->present_count; p++) {
        Slip kept[PAIR_SLIPS];
        int kept_count = 0;
        size_t i = world->present[p];
        for (size_t q = p + 1; q < world->present_count; q++)
            force_of_pair(world, i, world->present[q], kept, &kept_count);
        memcpy(world->pair_slips + i * PAIR_SLIPS, kept, (size_t)kept_count * sizeof *kept);
        world->pair_slip_count[i] = kept_count;
    }
}

/* Doors ------------------------------------------------------------------------------------------------------------ */

/* Would the leaf, swung open, stand in somebody? Then it waits. */
static bool leaf_is_free(const World *world, size_t door) {
    const Outline *outline = &world->house->outline;
    for (size_t f = 0; f < outline->face_count; f++) {
        const Face *face = &outline->faces[f];
        if (face->door != (int)door || face->presence != PRESENT_OPEN)
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

static void open_doors(World *world) {
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        int door = world->phase[i] == PHASE_MOVING ? drive_door_at_hand(world, i) : -1;
        Drive *drive = &world->drive[i];
        if (door < 0) {
            drive->handle = 0;
            continue;
        }
        drive->handle += world->clock.dt;
        if (drive->handle < world->house->plan.doors[door].opening_time)
            drive->stalled = 0; /* opening a door is getting on, waiting for its leaf's place is not */
        if (drive->handle >= world->house->plan.doors[door].opening_time && leaf_is_free(world, (size_t)door)) {
            world->door_open[door] = true;
            world->door_changes++;
        }
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

/* F3 and F4: everybody decides from the same frozen state. */
static void exert_efforts(World *world) {
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
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

static void leave(World *world, size_t i, Vec2 before) {
    const Plan *plan = &world->house->plan;
    Vec2 after = world_reference(world, i);
    double time = (double)(world->clock.step + 1) * world->clock.dt;
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        if (time >= exit->opens && time <= exit->closes && crosses(exit, before, after)) {
            world->phase[i] = PHASE_OUT;
            world->exit[i] = e;
            world->ended[i] = time;
            world->departures++;
            return;
        }
    }
}

static void give_up(World *world, size_t i, Reason reason) {
    world->phase[i] = PHASE_STUCK;
    world->reason[i] = reason;
    world->ended[i] = clock_time(&world->clock);
    world->drive[i].departures = world->departures;
}

/* Starts those whose delay is over; those for whom there is no way, or who no longer get on, stay where they are, the
 * latter until somebody else has left. */
static void change_phases(World *world) {
    double time = clock_time(&world->clock);
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        const Route *route = &world->journeys[i].route;
        if (world->phase[i] == PHASE_WAITING && time >= world->house->people[i].delay) {
            world->phase[i] = PHASE_MOVING;
            if (route->answer != ROUTE_FOUND)
                give_up(world, i, route->answer == ROUTE_NO_EXIT ? REASON_NO_EXIT : REASON_CANNOT_PASS);
        } else if (world->phase[i] == PHASE_MOVING && world->drive[i].stalled > world->house->plan.run.patience) {
            bool closed = time > world->house->plan.exits[route->exit].closes;
            give_up(world, i, closed ? REASON_NO_EXIT : REASON_BLOCKED);
        } else if (world->phase[i] == PHASE_STUCK && world->reason[i] == REASON_BLOCKED &&
                   world->drive[i].departures != world->departures) {
            world->phase[i] = PHASE_MOVING; /* somebody has left: perhaps there is room now */
            world->reason[i] = REASON_NONE;
            world->drive[i].stalled = 0;
        }
    }
}

/* Beginning and end ------------------------------------------------------------------------------------------------ */

World world_create(const House *house, const Journey *journeys, const bool *part) {
    World world = {.house = house,
                   .journeys = journeys,
                   .clock = {0, house->plan.run.dt},
                   .count = house->person_count,
                   .digest = 0xcbf29ce484222325u};
    world.block_size = lay_out(&world, NULL);
    world.block = memory_allocate(world.block_size, 1);
    lay_out(&world, world.block);
    for (size_t d = 0; d < house->plan.door_count; d++)
        world.door_open[d] = !outline_door_moves(&house->plan.doors[d]);
    for (size_t i = 0; i < world.count; i++) {
        place_person(&world, i, !part || part[i]);
        world.was_clear[i] = world_is_clear(&world, i);
    }
    list_present(&world);
    gather_forces(&world); /* what everybody feels before the first step */
    return world;
}

void world_destroy(World *world) {
    memory_free(world->block);
    *world = (World){0};
}

World world_copy(const World *world) {
    World copy = *world;
    copy.block = memory_allocate(world->block_size, 1);
    memcpy(copy.block, world->block, world->block_size);
    lay_out(&copy, copy.block);
    return copy;
}

/* Digest and divergence ----------------------------------------------------------------------------------------------
 */

static uint64_t mix(uint64_t digest, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    digest = (digest ^ bits) * 0x9e3779b97f4a7c15u;
    return digest ^ (digest >> 29);
}

/* Every person's digest is made by itself and the sum taken, so that the order of people does not matter. */
static void digest_states(World *world) {
    uint64_t sum = 0;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        uint64_t digest = mix(mix(0, world->centre[i].x), world->centre[i].y);
        digest = mix(mix(digest, world->velocity[i].x), world->velocity[i].y);
        sum += mix(mix(digest, world->heading[i]), world->turn[i]);
    }
    world->digest = (world->digest ^ sum) * 0x100000001b3u;
}

static bool is_sound(const World *world, size_t i) {
    Box box = box_expand(world->house->outline.box, 10); /* m: nobody is pushed farther out of the house */
    Vec2 at = world->centre[i];
    return at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y &&
           isfinite(world->heading[i]) && isfinite(world->turn[i]);
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
    for (size_t p = 0; p < world->present_count; p++) {
        int phase = world->phase[world->present[p]];
        if (phase == PHASE_WAITING || phase == PHASE_MOVING)
            return true;
    }
    return false;
}

/* Everybody who is left moves; whoever crosses an exit is gone. */
static WorldStatus move_everybody(World *world, size_t *who) {
    WorldStatus status = WORLD_OK;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        if (!world->was_clear[i])
            continue;
        Vec2 before = world_reference(world, i);
        move_person(world, i);
        if (world->phase[i] == PHASE_MOVING)
            leave(world, i, before);
        if (!is_sound(world, i)) {
            give_up(world, i, REASON_DIVERGED);
            status = WORLD_DIVERGED;
            if (who)
                *who = i;
        }
        /* What is deeper than the body's rounding is being pushed out by the contact law. */
        assert(status == WORLD_DIVERGED || world->sense[i].body_force > 0 || world_is_clear(world, i));
    }
    return status;
}

WorldStatus world_step(World *world, size_t *who) {
    int departures = world->departures;
    change_phases(world);
    open_doors(world);
    gather_forces(world);
    exert_efforts(world);
    WorldStatus status = move_everybody(world, who);
    if (world->departures != departures)
        list_present(world);
    world->clock.step++;
    digest_states(world);
    return status;
}
