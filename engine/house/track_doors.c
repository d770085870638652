#include "house/track_doors.h"

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

/* Returns the distance of a body at a track point from a place; at most 0 inside. */
static double body_distance(const Profile *profile, const TrackPoint *point, Vec2 place) {
    if (profile->driving == DRIVING_MIURA)
        return vec2_distance(place, point->at) - profile->width / 2;
    Vec2 local = vec2_unturn(vec2_sub(place, point->at), vec2_heading(point->heading));
    double ahead = fabs(local.x - (profile->length / 2 - profile->axle)) - profile->length / 2;
    double beside = fabs(local.y) - profile->width / 2;
    return ahead > 0 && beside > 0 ? vec2_length(vec2(ahead, beside)) : fmax(ahead, beside);
}

/* Returns the distance of a body at a track point from the leaf of a shut door. */
static double leaf_distance(const DoorWay *way, const Profile *profile, const TrackPoint *point) {
    double least = HUGE_VAL;
    for (int k = 0; k < DOOR_SAMPLES; k++)
        least = fmin(least, body_distance(profile, point, way->leaf[k]));
    return least;
}

static bool is_in_the_way(const DoorWay *way, const Profile *profile, const TrackPoint *point) {
    bool on_left = vec2_cross(vec2_sub(way->to, way->from), vec2_sub(point->at, way->from)) > 0;
    if (leaf_distance(way, profile, point) < DOOR_SPACE)
        return true;
    for (size_t k = 0; k < way->swing_count && on_left == way->swings_left; k++)
        if (body_distance(profile, point, way->swing[k]) < DOOR_SPACE)
            return true;
    return false;
}

void track_doors_mark(Track *track, const Plan *plan, const Profile *profile) {
    for (size_t i = 0; i < track->count; i++)
        track->points[i].door = -1;
    for (size_t d = 0; d < plan->door_count; d++) {
        if (!outline_door_moves(&plan->doors[d]))
            continue;
        DoorWay way = door_way(plan, &plan->doors[d]);
        for (size_t first = 0, i; first < track->count; first = i + 1) {
            double least = HUGE_VAL;
            for (i = first; i < track->count && is_in_the_way(&way, profile, &track->points[i]); i++)
                least = fmin(least, leaf_distance(&way, profile, &track->points[i]));
            if (least < LEAF_SPACE && track->points[first].door < 0)
                track->points[first].door = (int)d;
        }
    }
    int next_door = -1;
    for (size_t i = track->count; i-- > 0;) {
        next_door = track->points[i].door >= 0 ? (int)i : next_door;
        track->points[i].next_door = next_door;
    }
}
