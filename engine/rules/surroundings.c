#include "rules/surroundings.h"

#include <math.h>

static const double HAIR = 1e-6;   /* m, numerics: SOLIDS_GRID, on which faces are rounded */
static const double CORNER = 1e-9; /* m: numerics, a point this near to the end of a face is its end */

void surroundings_clear(Surroundings *near) {
    memory_free(near->items);
    *near = (Surroundings){.outline = near->outline, .rails = near->rails};
}

void surroundings_look(Surroundings *near, Vec2 at, double reach) {
    near->count = broadphase_query(near->outline->broadphase, box_around(at, reach), near->items, near->capacity);
    if (near->count <= near->capacity)
        return;
    near->items = memory_reserve(near->items, &near->capacity, near->count, sizeof *near->items);
    near->count = broadphase_query(near->outline->broadphase, box_around(at, reach), near->items, near->capacity);
}

const Face *surroundings_face(const Surroundings *near, size_t i, SeenFaces seen, int but_door) {
    if ((size_t)near->items[i] >= near->outline->face_count)
        return NULL;
    const Face *face = &near->outline->faces[near->items[i]];
    bool own = face->owner == OWNER_DOOR && face->index == but_door;
    bool rail = face->owner == OWNER_FURNITURE && near->rails && near->rails[face->index];
    bool is_seen = seen == SEE_ALL || (seen == SEE_RAILS ? rail : face->owner == OWNER_WALL) ||
                   (seen == SEE_WALLS_AND_LEAVES && face->owner == OWNER_DOOR);
    return is_seen && !own && outline_planned(face->presence) ? face : NULL;
}

double surroundings_ray(const Surroundings *near, Vec2 from, Vec2 along, double reach, SeenFaces seen) {
    double best = reach;
    for (size_t i = 0; i < near->count; i++) {
        const Face *face = surroundings_face(near, i, seen, -1);
        if (!face)
            continue;
        Vec2 line = vec2_sub(face->b, face->a), to = vec2_sub(face->a, from);
        double across = vec2_cross(along, line);
        if (across == 0)
            continue;
        double s = vec2_cross(to, line) / across, t = vec2_cross(to, along) / across;
        double beside = HAIR / vec2_length(line); /* 1: a ray at a joint of two faces meets one of them */
        if (t >= -beside && t <= 1 + beside && s > HAIR && s < best)
            best = s;
    }
    return best;
}

bool surroundings_nearest(const Surroundings *near, Vec2 at, double reach, SeenFaces seen, Vec2 *nearest) {
    double best = reach;
    bool inside = false;
    for (size_t i = 0; i < near->count; i++) {
        const Face *face = surroundings_face(near, i, seen, -1);
        if (!face || vec2_dot(vec2_sub(at, face->a), face->normal) < 0)
            continue;
        Vec2 point = vec2_nearest_on_segment(at, face->a, face->b);
        double distance = vec2_distance(point, at);
        if (distance >= best)
            continue;
        best = distance;
        *nearest = point;
        inside = vec2_distance(point, face->a) > CORNER && vec2_distance(point, face->b) > CORNER;
    }
    return inside && best > CORNER;
}

bool surroundings_clip(const Face *face, RuleFrame frame, RuleStrip strip, RuleStrip *u) {
    Vec2 a = vec2_unturn(vec2_sub(face->a, frame.origin), frame.along);
    Vec2 b = vec2_unturn(vec2_sub(face->b, frame.origin), frame.along);
    double low = strip.low + HAIR, high = strip.high - HAIR;
    if (fmax(a.y, b.y) < low || fmin(a.y, b.y) > high)
        return false;
    double slope = b.y != a.y ? (b.x - a.x) / (b.y - a.y) : 0;
    double first = a.y < low ? a.x + (low - a.y) * slope : a.y > high ? a.x + (high - a.y) * slope : a.x;
    double second = b.y < low ? a.x + (low - a.y) * slope : b.y > high ? a.x + (high - a.y) * slope : b.x;
    *u = (RuleStrip){fmin(first, second), fmax(first, second)};
    return true;
}
