#include "space/passage.h"

Passage passage_at(const Outline *outline, Vec2 at, Vec2 along) {
    Vec2 left = vec2_left(along);
    return (Passage){outline_ray(outline, at, left, PASSAGE_WIDEST, NULL),
                     outline_ray(outline, at, vec2_scale(left, -1), PASSAGE_WIDEST, NULL)};
}

double passage_across(const Outline *outline, Vec2 corner, Vec2 across) {
    const double hair = 1e-4; /* m: distance from the corner's own faces */
    return hair + outline_ray(outline, vec2_along(corner, hair, across), across, PASSAGE_WIDEST, NULL);
}

double passage_between(const Face *one, const Face *other, Vec2 *middle) {
    const int projections = 40; /* alternating projections lead to the nearest pair of two convex sets */
    Vec2 from = *middle, to = *middle;
    for (int i = 0; i < projections; i++) {
        from = vec2_nearest_on_segment(to, one->a, one->b);
        to = vec2_nearest_on_segment(from, other->a, other->b);
    }
    *middle = vec2_scale(vec2_add(from, to), 0.5);
    return vec2_distance(from, to);
}
