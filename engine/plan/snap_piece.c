#include "plan/snap_piece.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan/plan_geometry.h"

static const double PARALLEL = 0.002; /* 1: sine of the largest angle at which a side lies along a face */
static const double NEAR_WALL = 0.15; /* m: a back this near to a wall is placed against it */
static const double TOUCHING = 1e-9;  /* m: a face that begins here does not obstruct */

/* A face with free space on its right, seen from a to b. */
typedef struct SideFace {
    Vec2 a, b;
    const char *id;
} SideFace;

typedef void (*FaceVisit)(void *context, const SideFace *face);

static bool is_without(const char *id, const char *const *without, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (strcmp(without[i], id) == 0)
            return true;
    return false;
}

static void visit_walls(const Plan *plan, const SnapAsk *ask, FaceVisit visit, void *context) {
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        if (is_without(wall->id, ask->without, ask->without_count))
            continue;
        for (size_t s = 0; s + 1 < wall->points.count; s++) {
            Vec2 a = wall->points.at[s], b = wall->points.at[s + 1];
            Vec2 side = vec2_scale(vec2_left(vec2_unit(vec2_sub(b, a))), wall->thickness / 2);
            visit(context, &(SideFace){vec2_sub(a, side), vec2_sub(b, side), wall->id});
            visit(context, &(SideFace){vec2_add(b, side), vec2_add(a, side), wall->id});
        }
    }
}

static void visit_faces(const Plan *plan, const SnapAsk *ask, FaceVisit visit, void *context) {
    visit_walls(plan, ask, visit, context);
    for (size_t f = 0; f < plan->furniture_count; f++) {
        const Furniture *piece = &plan->furniture[f];
        Vec2 corners[4];
        plan_geometry_corners(piece, corners);
        for (int i = 0; i < 4 && !is_without(piece->id, ask->without, ask->without_count); i++)
            visit(context, &(SideFace){corners[i], corners[(i + 1) % 4], piece->id});
    }
}

static Vec2 normal_of(const SideFace *face) {
    return vec2_scale(vec2_left(vec2_unit(vec2_sub(face->b, face->a))), -1);
}

/* Touching -------------------------------------------------------------------------------------------------------- */

typedef struct Touch {
    Vec2 corners[4]; /* of the piece, with its middle at the pointer */
    double reach;
    double move[2];     /* m, along the piece's own x and y; HUGE_VAL: no face is near */
    const char *ids[2]; /* of the elements touched */
} Touch;

/* Returns the range of points along an axis. */
static void stretch(const Vec2 *points, size_t count, Vec2 axis, double *low, double *high) {
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        *low = fmin(*low, vec2_dot(points[i], axis));
        *high = fmax(*high, vec2_dot(points[i], axis));
    }
}

static void touch(void *context, const SideFace *face) {
    Touch *touching = context;
    Vec2 normal = normal_of(face), along = vec2_left(normal), ends[2] = {face->a, face->b};
    double low, high, begin, end;
    stretch(touching->corners, 4, along, &low, &high);
    stretch(ends, 2, along, &begin, &end);
    if (high < begin - touching->reach || low > end + touching->reach)
        return;
    for (int side = 0; side < 4; side++) {
        Vec2 a = touching->corners[side], b = touching->corners[(side + 1) % 4];
        Vec2 out = vec2_scale(vec2_left(vec2_unit(vec2_sub(b, a))), -1);
        if (vec2_dot(out, normal) > 0 || fabs(vec2_cross(out, normal)) > PARALLEL)
            continue;
        double move = vec2_dot(vec2_sub(face->a, a), out);
        int k = side % 2 == 0; /* front and back move the piece along its own y */
        if (fabs(move) > touching->reach || fabs(move) >= fabs(touching->move[k]))
            continue;
        touching->move[k] = side == 0 || side == 3 ? -move : move;
        touching->ids[k] = face->id;
    }
}

static double to_grid(double value, double grid) {
    return snap_tidy(round(value / grid) * grid);
}

Snap snap_piece_place(const Plan *plan, const Furniture *piece, const SnapAsk *ask) {
    Furniture moved = *piece;
    moved.centre = ask->at;
    double grid = ask->free ? SNAP_FREE_GRID : SNAP_GRID;
    Snap snap = {.at = vec2(to_grid(ask->at.x, grid), to_grid(ask->at.y, grid))};
    if (ask->free)
        return snap;
    Touch touching = {.reach = ask->reach, .move = {HUGE_VAL, HUGE_VAL}};
    plan_geometry_corners(&moved, touching.corners);
    visit_faces(plan, ask, touch, &touching);
    if (!touching.ids[0] && !touching.ids[1])
        return snap;
    Vec2 axis = snap_heading(piece->angle), own = vec2_unturn(ask->at, axis);
    for (int k = 0; k < 2; k++) {
        double *coordinate = k ? &own.y : &own.x;
        *coordinate = touching.ids[k] ? *coordinate + touching.move[k] : to_grid(*coordinate, SNAP_GRID);
    }
    Vec2 at = vec2_turn(own, axis);
    snap.at = vec2(snap_tidy(at.x), snap_tidy(at.y));
    bool both = touching.ids[0] && touching.ids[1] && strcmp(touching.ids[0], touching.ids[1]) != 0;
    char first[SNAP_NAME], second[SNAP_NAME] = "";
    snap_name(plan, ask, touching.ids[0] ? touching.ids[0] : touching.ids[1], snap.at, first);
    if (both)
        snap_name(plan, ask, touching.ids[1], snap.at, second);
    snprintf(snap.text, sizeof snap.text, both && strcmp(first, second) != 0 ? "against %s and %s" : "against %s",
             first, second);
    return snap;
}

/* Its back -------------------------------------------------------------------------------------------------------- */

typedef struct Backing {
    Vec2 at;
    double distance; /* m, of the nearest face */
    Vec2 foot, normal;
} Backing;

static void back(void *context, const SideFace *face) {
    Backing *backing = context;
    Vec2 normal = normal_of(face), foot = vec2_nearest_on_segment(backing->at, face->a, face->b);
    double before = vec2_dot(vec2_sub(backing->at, face->a), normal);
    double along = vec2_dot(vec2_sub(backing->at, face->a), vec2_unit(vec2_sub(face->b, face->a)));
    if (before < 0 || along < 0 || along > vec2_distance(face->a, face->b) || before >= backing->distance)
        return;
    *backing = (Backing){backing->at, before, foot, normal};
}

bool snap_piece_back(const Plan *plan, const Furniture *piece, const SnapAsk *ask, double *angle, Vec2 *centre) {
    Backing backing = {.at = ask->at, .distance = HUGE_VAL};
    visit_walls(plan, ask, back, &backing);
    if (ask->free || backing.distance > piece->size.y / 2 + fmax(ask->reach, NEAR_WALL))
        return false;
    double turned = remainder(snap_angle(vec2_scale(backing.normal, -1)) - 90, 360);
    *angle = snap_tidy(turned <= -180 ? 180 : turned);
    Vec2 at = vec2_along(backing.foot, piece->size.y / 2, backing.normal);
    *centre = vec2(snap_tidy(at.x), snap_tidy(at.y));
    return true;
}

/* Room ------------------------------------------------------------------------------------------------------------ */

typedef struct Gauge {
    Vec2 from, direction;
    double distance;
} Gauge;

static void meet(void *context, const SideFace *face) {
    Gauge *gauge = context;
    Vec2 side = vec2_sub(face->b, face->a), offset = vec2_sub(face->a, gauge->from);
    double turn = vec2_cross(gauge->direction, side);
    if (fabs(turn) < PARALLEL * vec2_length(side))
        return;
    double t = vec2_cross(offset, side) / turn, s = vec2_cross(offset, gauge->direction) / turn;
    if (t >= -TOUCHING && t < gauge->distance && s >= 0 && s <= 1)
        gauge->distance = fmax(t, 0);
}

double snap_piece_gap(const Plan *plan, Vec2 from, Vec2 direction, const char *const *without, size_t without_count) {
    SnapAsk ask = {.without = without, .without_count = without_count};
    Gauge gauge = {from, direction, HUGE_VAL};
    visit_faces(plan, &ask, meet, &gauge);
    return gauge.distance;
}
