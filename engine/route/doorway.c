#include "route/doorway.h"

#include <stdbool.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "space/outline.h"

/* m, assumed: distance from a shut door's leaf, and from its swing. */
static const double DOOR_SPACE = 0.10;
/* m, assumed: a shut door is opened for a body that comes nearer than this to its leaf. */
static const double LEAF_SPACE = 0.03;
/* places checked along a leaf of 1 m: 8 cm apart */
enum { DOOR_SAMPLES = 13 };

/* The space that a shut door needs: its leaf and, on the side to which it opens, the leaf's swing. */
typedef struct DoorWay {
    Vec2 leaf[DOOR_SAMPLES];
    Vec2 swing[DOOR_SAMPLES * DOOR_SAMPLES];
    size_t swing_count;
    bool swings_left;
    Vec2 from, to;
} DoorWay;

static DoorWay door_way(const Plan *plan, const Door *door) {
    DoorWay way = {.swings_left = door->swing == SWING_LEFT};
    plan_geometry_door_ends(plan, door, &way.from, &way.to);
    Vec2 along = vec2_sub(way.to, way.from);
    for (int k = 0; k < DOOR_SAMPLES; k++)
        way.leaf[k] = vec2_along(way.from, (double)k / (DOOR_SAMPLES - 1), along);
    if (door->kind != DOOR_HINGED)
        return way;
    bool at_start = door->hinge == HINGE_START;
    Vec2 hinge = at_start ? way.from : way.to, leaf = at_start ? along : vec2_scale(along, -1);
    double turn = at_start == way.swings_left ? M_PI / 2 : -M_PI / 2;
    for (int k = 0; k < DOOR_SAMPLES; k++)
        for (int r = 1; r <= DOOR_SAMPLES; r++)
            way.swing[way.swing_count++] = vec2_along(hinge, (double)r / DOOR_SAMPLES,
                                                      vec2_turn(leaf, vec2_heading(turn * k / (DOOR_SAMPLES - 1))));
    return way;
}

/* Returns the distance of a standing body from a point, m; at most 0 inside. */
static double body_distance(const Profile *profile, const DoorwayPlace *stands, Vec2 place) {
    if (profile->driving == DRIVING_MIURA)
        return vec2_distance(place, stands->at) - profile->width / 2;
    Vec2 local = vec2_unturn(vec2_sub(place, stands->at), stands->axis);
    double ahead = fabs(local.x - (profile->length / 2 - profile->axle)) - profile->length / 2;
    double beside = fabs(local.y) - profile->width / 2;
    return ahead > 0 && beside > 0 ? vec2_length(vec2(ahead, beside)) : fmax(ahead, beside);
}

/* Returns the distance of a standing body from the leaf of a shut door, m. */
static double leaf_distance(const DoorWay *way, const Profile *profile, const DoorwayPlace *stands) {
    double least = HUGE_VAL;
    for (int k = 0; k < DOOR_SAMPLES; k++)
        least = fmin(least, body_distance(profile, stands, way->leaf[k]));
    return least;
}

static bool is_in_the_way(const DoorWay *way, const Profile *profile, const DoorwayPlace *stands) {
    bool on_left = vec2_cross(vec2_sub(way->to, way->from), vec2_sub(stands->at, way->from)) > 0;
    if (leaf_distance(way, profile, stands) < DOOR_SPACE)
        return true;
    for (size_t k = 0; k < way->swing_count && on_left == way->swings_left; k++)
        if (body_distance(profile, stands, way->swing[k]) < DOOR_SPACE)
            return true;
    return false;
}

/* True if the body stands so far from a door that nothing of it can be in the way. */
static bool is_far(const DoorWay *way, const Profile *profile, const DoorwayPlace *stands) {
    double width = vec2_distance(way->from, way->to);
    return vec2_distance(stands->at, way->from) > 2 * width + profile->length + profile->width + DOOR_SPACE;
}

void doorway_mark(int *doors, const DoorwayPlace *places, size_t count, const Plan *plan, const Profile *profile) {
    for (size_t i = 0; i < count; i++)
        doors[i] = -1;
    for (size_t d = 0; d < plan->door_count; d++) {
        if (!outline_door_moves(&plan->doors[d]))
            continue;
        DoorWay way = door_way(plan, &plan->doors[d]);
        for (size_t first = 0, i; first < count; first = i + 1) {
            double least = HUGE_VAL;
            for (i = first; i < count && !is_far(&way, profile, &places[i]) && is_in_the_way(&way, profile, &places[i]);
                 i++)
                least = fmin(least, leaf_distance(&way, profile, &places[i]));
            if (least < LEAF_SPACE && doors[first] < 0)
                doors[first] = (int)d;
        }
    }
}

double doorway_delay(const DoorwayPlace *places, size_t count, const Plan *plan, const Profile *profile) {
    int *doors = memory_zeroed(count, sizeof *doors);
    bool *opened = memory_zeroed(plan->door_count, sizeof *opened);
    double delay = 0;
    doorway_mark(doors, places, count, plan, profile);
    for (size_t i = 0; i < count; i++)
        if (doors[i] >= 0 && !opened[doors[i]]) {
            opened[doors[i]] = true;
            delay += plan->doors[doors[i]].opening_time;
        }
    memory_free(doors);
    memory_free(opened);
    return delay;
}
