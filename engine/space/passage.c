#include "space/passage.h"

#include "base/real.h"

Passage passage_at(const Outline *outline, Vec2 at, Vec2 along) {
    Vec2 left = vec2_left(along);
    return (Passage){outline_ray(outline, at, left, PASSAGE_WIDEST, NULL),
                     outline_ray(outline, at, vec2_scale(left, -1), PASSAGE_WIDEST, NULL)};
}

Passage passage_within(const FreeSpace *space, Vec2 at, Vec2 along, double half) {
    enum { MOST = 64 };
    const double hair = 1e-9; /* m */
    int faces[MOST];
    int count = freespace_faces(space, at, along, 0, half, hair, faces, MOST);
    double left = half, right = half;
    for (int f = 0; f < count; f++) {
        const Face *face = &space->outline->faces[faces[f]];
        Vec2 a = vec2_sub(face->a, at), b = vec2_sub(face->b, at);
        double ahead_a = vec2_dot(along, a), ahead_b = vec2_dot(along, b);
        if (ahead_a * ahead_b > 0 || !(fabs(ahead_a - ahead_b) > 0))
            continue;
        double beside_a = vec2_cross(along, a), beside_b = vec2_cross(along, b);
        double beside = beside_a + ahead_a / (ahead_a - ahead_b) * (beside_b - beside_a);
        if (beside > 0)
            left = real_min(left, beside);
        else
            right = real_min(right, -beside);
    }
    return (Passage){left, right};
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
