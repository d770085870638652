#include "rules/doorway.h"

#include <math.h>
#include <stdint.h>

#include "plan/plan_geometry.h"
#include "rules/surroundings.h"

static const double LEAF_ROOT = 0.02; /* m, beyond the wall's faces: there an open leaf begins to hang */
static const double BEFORE = 1.0;     /* m, before a door, from where a way's direction tells the approach */
static const double NEAREST = 0.3;    /* m: ways that begin nearer to the door do not approach it */
static const double SLACK = 0.0005;   /* m, by which a space is smaller than its surroundings: rounded drawings */
static const double FRONT_COSINE = 0.8660254037844387; /* 1, of 30 degrees */

/* The frame of a door: its middle, and the direction of its wall. */
static RuleFrame frame_of(const Plan *plan, const Door *door, double *half_width, double *half_wall) {
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    *half_width = vec2_distance(from, to) / 2;
    *half_wall = plan->walls[door->wall_index].thickness / 2;
    return (RuleFrame){vec2_scale(vec2_add(from, to), 0.5), vec2_unit(vec2_sub(to, from))};
}

static Vec2 place_in(RuleFrame frame, double u, double v) {
    return vec2_add(frame.origin, vec2_turn(vec2(u, v), frame.along));
}

bool doorway_pulls(const Door *door, int side) {
    return (door->swing == SWING_LEFT) == (side > 0);
}

/* Returns +1 if the latch is at the end of the wall's direction. */
static int latch_of(const Door *door) {
    return door->hinge == HINGE_START ? 1 : -1;
}

/* The opening -------------------------------------------------------------------------------------------------------
 */

static void measure_opening(Doorway *doorway, Surroundings *near, RuleFrame frame, double half_width,
                            double half_wall) {
    double left = -2 * half_width - 1, right = 2 * half_width + 1;
    surroundings_look(near, frame.origin, half_width + half_wall + 1);
    for (size_t i = 0; i < near->count; i++) {
        const Face *face = surroundings_face(near, i, SEE_WALLS_AND_LEAVES, -1);
        RuleStrip u;
        if (!face || !surroundings_clip(face, frame, (RuleStrip){-half_wall - LEAF_ROOT, half_wall + LEAF_ROOT}, &u))
            continue;
        if (u.low < 0 && u.high > 0)
            left = right = 0;
        else if (u.low >= 0)
            right = fmin(right, u.low);
        else
            left = fmax(left, u.high);
    }
    doorway->from = place_in(frame, left, 0);
    doorway->to = place_in(frame, right, 0);
    doorway->clear = right - left;
}

/* Approaches --------------------------------------------------------------------------------------------------------
 */

static void add_use(Doorway *doorway, DoorwayUse use) {
    for (size_t i = 0; i < doorway->use_count; i++)
        if (doorway->uses[i].side == use.side && doorway->uses[i].approach == use.approach)
            return;
    if (doorway->use_count < DOORWAY_USES)
        doorway->uses[doorway->use_count++] = use;
}

/* Adds how a way comes to the door that it passes between place `i` and the next one: by the direction to the door's
 * middle of the last place that is 1 m away or, where the leaf opens towards it, 1 m and the leaf's length. */
static void add_passing(Doorway *doorway, const Door *door, const RuleWay *way, size_t i, RuleFrame frame,
                        double half_wall) {
    size_t nearest = (size_t)((NEAREST + half_wall) / WAYS_STEP), before = i;
    DoorwayUse use = {.side = vec2_unturn(vec2_sub(way->at[i], frame.origin), frame.along).y > 0 ? 1 : -1};
    bool opens = door->kind == DOOR_HINGED && doorway_pulls(door, use.side);
    double away = half_wall + BEFORE + (opens ? door->width : 0);
    if (i < nearest)
        return;
    while (before > 0 && vec2_distance(way->at[before], frame.origin) < away)
        before--;
    Vec2 place = vec2_unturn(vec2_sub(way->at[before], frame.origin), frame.along);
    bool front = fabs(place.y) >= FRONT_COSINE * vec2_length(place);
    bool from_latch = place.x * latch_of(door) > 0;
    use.approach = front ? APPROACH_FRONT : from_latch ? APPROACH_LATCH : APPROACH_HINGE;
    add_use(doorway, use);
}

static void add_uses(Doorway *doorway, const House *house, const RuleWays *ways, RuleFrame frame, double half_wall) {
    for (size_t w = 0; w < ways->count; w++) {
        const RuleWay *way = &ways->ways[w];
        for (size_t i = 0; i + 1 < way->count; i++)
            if (ways_meet(way->at[i], way->at[i + 1], doorway->from, doorway->to)) {
                add_passing(doorway, &house->plan.doors[doorway->door], way, i, frame, half_wall);
                break;
            }
    }
}

/* The whole ---------------------------------------------------------------------------------------------------------
 */

static bool is_near_exit(const Plan *plan, Vec2 middle) {
    for (size_t e = 0; e < plan->exit_count; e++)
        if (vec2_distance(middle, vec2_nearest_on_segment(middle, plan->exits[e].from, plan->exits[e].to)) <=
            DOORWAY_ENTRANCE)
            return true;
    return false;
}

Doorway doorway_measure(const House *house, const RuleWays *ways, size_t door) {
    double half_width, half_wall;
    const Plan *plan = &house->plan;
    RuleFrame frame = frame_of(plan, &plan->doors[door], &half_width, &half_wall);
    Surroundings near = {.outline = &house->outline};
    Doorway doorway = {.door = door, .entrance = is_near_exit(plan, frame.origin)};
    measure_opening(&doorway, &near, frame, half_width, half_wall);
    surroundings_look(&near, frame.origin, DOORWAY_DEEPEST + half_wall);
    for (int k = 0; k < 2; k++) {
        int side = k ? -1 : 1;
        Vec2 out = vec2_scale(vec2_left(frame.along), side), face = place_in(frame, 0, side * half_wall);
        doorway.rooms[k] = ways_room(plan, vec2_along(face, 0.1, out));
        doorway.spaces[k] = surroundings_ray(&near, face, out, DOORWAY_DEEPEST, SEE_WALLS);
    }
    add_uses(&doorway, house, ways, frame, half_wall);
    surroundings_clear(&near);
    return doorway;
}

/* The spaces before it ----------------------------------------------------------------------------------------------
 */

/* Returns the least first coordinate at which a face enters the strip beyond `start`, at most `most`. */
static double free_along(const Surroundings *near, RuleFrame frame, RuleStrip strip, double start, double most,
                         int door) {
    double best = most;
    for (size_t i = 0; i < near->count; i++) {
        const Face *face = surroundings_face(near, i, SEE_ALL, door);
        RuleStrip u;
        if (face && surroundings_clip(face, frame, strip, &u) && u.high > start + SLACK)
            best = fmin(best, fmax(u.low, start));
    }
    return best;
}

DoorwaySpace doorway_space(const House *house, const Doorway *doorway, int side, double depth, double beyond,
                           bool at_hinge) {
    double half_width, half_wall;
    const Door *door = &house->plan.doors[doorway->door];
    RuleFrame frame = frame_of(&house->plan, door, &half_width, &half_wall);
    int latch = latch_of(door) * (at_hinge ? -1 : 1);
    Surroundings near = {.outline = &house->outline};
    surroundings_look(&near, frame.origin, half_width + half_wall + depth + beyond + 1);
    /* Outwards: from the wall's face on, away from the door; the second axis points to the left of that. */
    RuleFrame outwards = {place_in(frame, 0, side * half_wall), vec2_scale(vec2_left(frame.along), side)};
    int left =
        side > 0 ? -1 : 1; /* of the wall's direction, seen in the frame outwards: its axis is opposite, or not */
    double far = latch * left * (half_width + beyond), near_end = -latch * left * half_width;
    RuleStrip strip = {fmin(far, near_end) + SLACK, fmax(far, near_end) - SLACK};
    DoorwaySpace space = {.depth = free_along(&near, outwards, strip, 0, depth, (int)doorway->door)};
    /* Beside the opening: along the wall, away from its middle. */
    RuleFrame beside = {outwards.origin, vec2_scale(frame.along, latch)};
    int sense = latch * side; /* +1: outwards is to the left of that direction */
    RuleStrip deep = {sense > 0 ? SLACK : -depth + SLACK, sense > 0 ? depth - SLACK : -SLACK};
    space.beyond = free_along(&near, beside, deep, -half_width, half_width + beyond, (int)doorway->door) - half_width;
    bool is_deep = space.depth >= depth - SLACK;
    double middle = (far + near_end) / 2;
    space.from =
        is_deep && beyond > 0 ? place_in(beside, half_width, sense * depth / 2) : place_in(outwards, 0, middle);
    space.to = is_deep && beyond > 0 ? place_in(beside, half_width + space.beyond, sense * depth / 2)
                                     : place_in(outwards, space.depth, middle);
    surroundings_clear(&near);
    return space;
}
