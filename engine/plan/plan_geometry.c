#include "plan/plan_geometry.h"

void plan_geometry_door_ends(const Plan *plan, const Door *door, Vec2 *from, Vec2 *to) {
    const Vec2 *points = plan->walls[door->wall_index].points.at + door->segment;
    Vec2 along = vec2_unit(vec2_sub(points[1], points[0]));
    *from = vec2_along(points[0], door->at - door->width / 2, along);
    *to = vec2_along(points[0], door->at + door->width / 2, along);
}

void plan_geometry_corners(const Furniture *piece, Vec2 corners[4]) {
    double left = -piece->size.x / 2, right = -left, front = -piece->size.y / 2, back = -front;
    if (piece->toppled) {
        left -= piece->topples == TOPPLE_LEFT ? piece->height : 0;
        right += piece->topples == TOPPLE_RIGHT ? piece->height : 0;
        front -= piece->topples == TOPPLE_FRONT ? piece->height : 0;
        back += piece->topples == TOPPLE_BACK ? piece->height : 0;
    }
    Vec2 axis = vec2_heading(radians(piece->angle));
    Vec2 own[4] = {{left, front}, {right, front}, {right, back}, {left, back}};
    for (int i = 0; i < 4; i++)
        corners[i] = vec2_add(piece->centre, vec2_turn(own[i], axis));
}

/* m: a place this near to an exit's line is on it. Rounding moves places and lines by far less, motions by far more. */
static const double ON_LINE = 1e-9;

bool plan_geometry_is_open(const Exit *exit, double time) {
    return time >= exit->opens && time < exit->closes;
}

/* m: lines this near to one another are one. */
static const double SAME_LINE = 0.01;

bool plan_geometry_covers(const Exit *other, const Exit *exit) {
    Vec2 from = vec2_nearest_on_segment(exit->from, other->from, other->to);
    Vec2 to = vec2_nearest_on_segment(exit->to, other->from, other->to);
    return vec2_distance(from, exit->from) < SAME_LINE && vec2_distance(to, exit->to) < SAME_LINE;
}

bool plan_geometry_bars(const Plan *plan, size_t exit, double time) {
    if (plan_geometry_is_open(&plan->exits[exit], time))
        return false;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan_geometry_is_open(&plan->exits[e], time) && plan_geometry_covers(&plan->exits[e], &plan->exits[exit]))
            return false;
    return true;
}

int plan_geometry_side(const Exit *exit, Vec2 at) {
    Vec2 line = vec2_sub(exit->to, exit->from);
    double left = vec2_cross(line, vec2_sub(at, exit->from)); /* m2, the distance times the line's length */
    if (left * left <= ON_LINE * ON_LINE * vec2_dot(line, line))
        return 0;
    return left > 0 ? 1 : -1;
}

bool plan_geometry_leads_out(const Exit *exit, Vec2 from, Vec2 to) {
    if (plan_geometry_side(exit, from) == plan_geometry_side(exit, to))
        return false;
    Vec2 motion = vec2_sub(to, from);
    double one = vec2_cross(motion, vec2_sub(exit->from, from)), other = vec2_cross(motion, vec2_sub(exit->to, from));
    return (one <= 0 && other >= 0) || (one >= 0 && other <= 0);
}
