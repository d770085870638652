#include "visual/house/burst.h"

#include <math.h>

enum { POINTS = 16 };

Primitive *burst_add(Scene *scene, Vec2 at, double radius) {
    Vec2 star[POINTS];
    for (int k = 0; k < POINTS; k++)
        star[k] = vec2_along(at, k % 2 ? radius / 2 : radius, vec2_heading(2 * M_PI * k / POINTS));
    Primitive *burst = scene_add_polygon(scene, ROLE_DANGER_MIDDLE, star, POINTS);
    burst->edge = ROLE_WALL;
    return burst;
}
