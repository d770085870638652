#include "base/rectangle.h"

#include <math.h>

void rectangle_corners(Vec2 middle, Vec2 axis, Vec2 size, Vec2 corners[4]) {
    for (int i = 0; i < 4; i++) {
        Vec2 own = {i == 0 || i == 3 ? -size.x / 2 : size.x / 2, i < 2 ? -size.y / 2 : size.y / 2};
        corners[i] = vec2_add(middle, vec2_turn(own, axis));
    }
}

/* Returns the overlap of the projections on an axis (unit). */
static double shadows_overlap(const Vec2 a[4], const Vec2 b[4], Vec2 axis) {
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 8; i++) {
        double at = vec2_dot(i < 4 ? a[i] : b[i - 4], axis);
        low[i / 4] = fmin(low[i / 4], at);
        high[i / 4] = fmax(high[i / 4], at);
    }
    return fmin(high[0] - low[1], high[1] - low[0]);
}

double rectangle_overlap(const Vec2 a[4], const Vec2 b[4]) {
    double least = HUGE_VAL;
    for (int r = 0; r < 2; r++) {
        const Vec2 *corners = r ? b : a;
        Vec2 along = vec2_unit(vec2_sub(corners[1], corners[0]));
        least = fmin(least, fmin(shadows_overlap(a, b, along), shadows_overlap(a, b, vec2_left(along))));
    }
    return least;
}
