#include "inquiry/suggest_change.h"

#include <math.h>

#include "base/real.h"
#include "base/rectangle.h"
#include "base/text.h"
#include "plan/plan_geometry.h"
#include "space/outline.h"
#include "space/solids.h"

#define TOUCH 0.002      /* m: walls and furniture that overlap by less only touch */
#define LEAF_TOUCH 0.005 /* m: as drawn, what stands beside a door may overlap its open leaf by less */
#define JOINT 1e-3       /* m: walls this near to each other meet */
#define ROUNDING 1e-3    /* m, of displacements */
#define VANISHED "0.01"  /* m, the size of a removed piece, inside a wall */

/* Doors ------------------------------------------------------------------------------------------------------------ */

/* Removes an occupied stretch of the door's segment. */
static void take_out(double door_at, double from, double to, double *low, double *high) {
    if ((from + to) / 2 < door_at)
        *low = fmax(*low, to);
    else
        *high = fmin(*high, from);
}

/* Removes the thickness of a wall segment where it meets that of the door. */
static void take_out_wall(const Plan *plan, const Door *door, const Vec2 *own, const Wall *other, const Vec2 *segment,
                          double *low, double *high) {
    double half = plan->walls[door->wall_index].thickness / 2;
    Vec2 along = vec2_unit(vec2_sub(own[1], own[0])), way = vec2_sub(segment[1], segment[0]);
    for (int end = 0; end < 2; end++) {
        Vec2 nearest = vec2_nearest_on_segment(segment[end], own[0], own[1]);
        double at = vec2_dot(vec2_sub(nearest, own[0]), along);
        if (vec2_distance(segment[end], nearest) <= half + JOINT)
            take_out(door->at, at - other->thickness / 2, at + other->thickness / 2, low, high);
    }
    double sides[2] = {vec2_cross(along, vec2_sub(segment[0], own[0])),
                       vec2_cross(along, vec2_sub(segment[1], own[0]))};
    if (sides[0] * sides[1] >= 0)
        return;
    double share = sides[0] / (sides[0] - sides[1]);
    double at = vec2_dot(vec2_sub(vec2_along(segment[0], share, way), own[0]), along);
    if (at > 0 && at < vec2_distance(own[0], own[1]))
        take_out(door->at, at - other->thickness / 2, at + other->thickness / 2, low, high);
}

void suggest_change_room(const Plan *plan, size_t d, double *low, double *high) {
    const Door *door = &plan->doors[d];
    const Vec2 *own = plan->walls[door->wall_index].points.at + door->segment;
    *low = 0;
    *high = vec2_distance(own[0], own[1]);
    for (size_t o = 0; o < plan->door_count; o++) {
        const Door *other = &plan->doors[o];
        if (o != d && other->wall_index == door->wall_index && other->segment == door->segment)
            take_out(door->at, other->at - other->width / 2, other->at + other->width / 2, low, high);
    }
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Points *points = &plan->walls[w].points;
        for (size_t s = 0; s + 1 < points->count; s++)
            if (points->at + s != own)
                take_out_wall(plan, door, own, &plan->walls[w], points->at + s, low, high);
    }
    *low = fmin(*low, door->at - door->width / 2);
    *high = fmax(*high, door->at + door->width / 2);
}

Change suggest_change_widen(const Plan *plan, size_t d, double width) {
    double low, high;
    suggest_change_room(plan, d, &low, &high);
    double at = fmax(fmin(plan->doors[d].at, high - width / 2), low + width / 2);
    return (Change){.kind = CHANGE_WIDEN, .index = d, .width = width, .at = at};
}

/* Furniture -------------------------------------------------------------------------------------------------------- */

static double rounded(double value) {
    return ROUNDING * round(value / ROUNDING);
}

Change suggest_change_move(size_t piece, double far, double direction) {
    Vec2 by = vec2_scale(vec2_heading(direction), far);
    return (Change){.kind = CHANGE_MOVE, .index = piece, .by = vec2(rounded(by.x), rounded(by.y))};
}

static Furniture changed_piece(const Plan *plan, const Change *change) {
    Furniture piece = plan->furniture[change->index];
    piece.centre = vec2_add(piece.centre, change->by);
    piece.angle += change->angle;
    return piece;
}

/* True if the piece overlaps the other one no deeper than before. */
static bool no_deeper(const Vec2 before[4], const Vec2 after[4], const Vec2 solid[4]) {
    return rectangle_overlap(after, solid) <= fmax(rectangle_overlap(before, solid), TOUCH);
}

/* Fills in the leaf of a door as it stands open; false: it has none. */
static bool open_leaf(const Plan *plan, size_t d, Vec2 corners[4]) {
    const Door *door = &plan->doors[d];
    if (door->kind != DOOR_HINGED || door->state == DOOR_LOCKED)
        return false;
    solids_open_leaf(plan, door, plan->walls[door->wall_index].thickness / 2, corners);
    return true;
}

static bool cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    Vec2 one = vec2_sub(b, a), two = vec2_sub(d, c);
    double c_side = vec2_cross(one, vec2_sub(c, a)), d_side = vec2_cross(one, vec2_sub(d, a));
    double a_side = vec2_cross(two, vec2_sub(a, c)), b_side = vec2_cross(two, vec2_sub(b, c));
    return c_side * d_side <= 0 && a_side * b_side < 0;
}

bool suggest_change_stands_free(const Plan *plan, const Change *change) {
    const Furniture *piece = &plan->furniture[change->index];
    Furniture moved = changed_piece(plan, change);
    Vec2 before[4], after[4], solid[4];
    plan_geometry_corners(piece, before);
    plan_geometry_corners(&moved, after);
    for (size_t f = 0; f < plan->furniture_count; f++) {
        plan_geometry_corners(&plan->furniture[f], solid);
        if (f != change->index && !no_deeper(before, after, solid))
            return false;
    }
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        for (size_t s = 0; s + 1 < wall->points.count; s++) {
            const Vec2 *ends = wall->points.at + s;
            solids_strip(ends[0], ends[1], wall->thickness / 2, wall->thickness / 2, solid);
            if (!no_deeper(before, after, solid) || cross(piece->centre, moved.centre, ends[0], ends[1]))
                return false;
        }
    }
    for (size_t d = 0; d < plan->door_count; d++)
        if (open_leaf(plan, d, solid) && !no_deeper(before, after, solid))
            return false;
    return true;
}

size_t suggest_change_leaf(const Plan *plan, size_t piece, size_t door) {
    Vec2 corners[4], leaf[4];
    plan_geometry_corners(&plan->furniture[piece], corners);
    while (door < plan->door_count && !(open_leaf(plan, door, leaf) && rectangle_overlap(corners, leaf) > LEAF_TOUCH))
        door++;
    return door;
}

/* What is said of it ----------------------------------------------------------------------------------------------- */

double suggest_change_size(const Plan *plan, const Change *change) {
    const Furniture *piece = &plan->furniture[change->index];
    switch (change->kind) {
    case CHANGE_WIDEN:
        return change->width - plan->doors[change->index].width;
    case CHANGE_MOVE:
        return vec2_length(change->by);
    case CHANGE_TURN:
        return 2 * fabs(real_sin(radians(change->angle) / 2)) * vec2_length(piece->size) / 2;
    case CHANGE_RAISE:
        return piece->height;
    case CHANGE_AWAY:
        break;
    }
    return 0;
}

static size_t away_settings(const Plan *plan, const char *id, const char **settings, Arena *arena) {
    Vec2 hidden = plan->walls[0].points.at[0];
    settings[0] = text_in_arena(arena, "furniture.%s.size=[" VANISHED ", " VANISHED "]", id);
    settings[1] = text_in_arena(arena, "furniture.%s.toppled=false", id);
    settings[2] = text_in_arena(arena, "furniture.%s.centre=[%.10g, %.10g]", id, hidden.x, hidden.y);
    return 3;
}

size_t suggest_change_settings(const Plan *plan, const Change *change, const char **settings, Arena *arena) {
    size_t count = 0;
    if (change->kind == CHANGE_WIDEN) {
        const Door *door = &plan->doors[change->index];
        settings[count++] = text_in_arena(arena, "door.%s.width=%.10g", door->id, change->width);
        if (fabs(change->at - door->at) > ROUNDING / 1000)
            settings[count++] = text_in_arena(arena, "door.%s.at=%.10g", door->id, change->at);
        return count;
    }
    const Furniture *piece = &plan->furniture[change->index];
    if (change->kind == CHANGE_AWAY)
        return away_settings(plan, piece->id, settings, arena);
    if (change->kind == CHANGE_RAISE)
        settings[count++] = text_in_arena(arena, "furniture.%s.toppled=false", piece->id);
    if (change->by.x != 0)
        settings[count++] =
            text_in_arena(arena, "furniture.%s.centre.x=%.10g", piece->id, piece->centre.x + change->by.x);
    if (change->by.y != 0)
        settings[count++] =
            text_in_arena(arena, "furniture.%s.centre.y=%.10g", piece->id, piece->centre.y + change->by.y);
    if (change->angle != 0) /* within the range of a file */
        settings[count++] =
            text_in_arena(arena, "furniture.%s.angle=%.10g", piece->id, remainder(piece->angle + change->angle, 360));
    return count;
}

PlanWork suggest_change_work(const Plan *plan, const Change *change) {
    if (change->kind != CHANGE_WIDEN)
        return WORK_FURNITURE;
    int kind = plan->doors[change->index].kind;
    return kind == DOOR_HINGED ? WORK_HINGED_DOOR : kind == DOOR_OPENING ? WORK_OPENING : WORK_SLIDING_DOOR;
}

/* Returns "0.30 m to the right and 0.10 m up", as on the plan. */
static const char *way_words(Vec2 by, Arena *arena) {
    const char *across = by.x > 0 ? "to the right" : "to the left", *along = by.y > 0 ? "up" : "down";
    if (by.y == 0)
        return text_in_arena(arena, "%.3g m %s", fabs(by.x), across);
    if (by.x == 0)
        return text_in_arena(arena, "%.3g m %s", fabs(by.y), along);
    return text_in_arena(arena, "%.3g m %s and %.3g m %s", fabs(by.x), across, fabs(by.y), along);
}

const char *suggest_change_words(const Plan *plan, const Change *change, Arena *arena) {
    if (change->kind == CHANGE_WIDEN) {
        const Door *door = &plan->doors[change->index];
        bool whole = fabs(door->width * 100 - round(door->width * 100)) < 1e-6; /* whole centimetres */
        return text_in_arena(arena, "widen door %s from %.*f m to %.2f m", door->id, whole ? 2 : 3, door->width,
                             change->width);
    }
    char name[96];
    outline_name(plan, OWNER_FURNITURE, (int)change->index, name, sizeof name);
    switch (change->kind) {
    case CHANGE_MOVE:
        return text_in_arena(arena, "move %s %s on the plan", name, way_words(change->by, arena));
    case CHANGE_TURN:
        return text_in_arena(arena, "turn %s by %g degrees", name, fabs(change->angle));
    case CHANGE_RAISE:
        return text_in_arena(arena, "stand %s up", name);
    case CHANGE_AWAY:
    case CHANGE_WIDEN:
        break;
    }
    return text_in_arena(arena, "take %s away", name);
}
