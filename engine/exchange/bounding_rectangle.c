#include "exchange/bounding_rectangle.h"

#include "base/real.h"

static const double ROUNDING = 1e-9; /* 1, or degree */

enum { TRIES = 64 /* side directions that are tried */ };

/* Returns the box of an outline along the unit vector `axis`. */
static Box turned_box(const Vec2 *points, size_t count, Vec2 axis) {
    Box box = box_empty();
    for (size_t i = 0; i < count; i++)
        box = box_include(box, vec2_unturn(points[i], axis));
    return box;
}

Rectangle bounding_rectangle_of(const Vec2 *points, size_t count) {
    Vec2 best_axis = {1, 0};
    Box best = turned_box(points, count, best_axis);
    size_t step = count / TRIES + 1;
    for (size_t i = 0; i < count; i += step) {
        Vec2 axis = vec2_unit(vec2_sub(points[(i + 1) % count], points[i]));
        if (axis.x == 0 && axis.y == 0)
            continue;
        Box box = turned_box(points, count, axis);
        if (box_width(box) * box_height(box) < box_width(best) * box_height(best) * (1 - ROUNDING)) {
            best = box;
            best_axis = axis;
        }
    }
    if (box_width(best) < box_height(best) * (1 - ROUNDING)) { /* make the first side the longer one */
        best_axis = vec2_left(best_axis);
        best = turned_box(points, count, best_axis);
    }
    double angle = degrees(real_atan2(best_axis.y, best_axis.x));
    if (angle <= -90 + ROUNDING || angle > 90 + ROUNDING) /* the axis has no sign */
        angle += angle > 0 ? -180 : 180;
    return (Rectangle){.centre = vec2_turn(vec2_scale(vec2_add(best.low, best.high), 0.5), best_axis),
                       .size = vec2(box_width(best), box_height(best)),
                       .angle = angle};
}
