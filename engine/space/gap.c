#include "space/gap.h"

/* The part of a body in a key: the corners 0 to 3 of its core, or its sides. */
enum { PART_SIDE = 4, PARTS = GAP_PARTS };

static size_t add_gap(Gap *gaps, size_t count, Gap gap) {
    if (count < GAPS_MOST) {
        gaps[count] = gap;
        return count + 1;
    }
    size_t widest = 0;
    for (size_t i = 1; i < count; i++)
        if (gaps[i].gap > gaps[widest].gap)
            widest = i;
    if (gap.gap < gaps[widest].gap)
        gaps[widest] = gap;
    return count;
}

static void fill_shares(Gap *gaps, size_t count, double reach) {
    for (size_t i = 0; i < count; i++) {
        double sum = 0;
        for (size_t j = 0; j < count; j++) {
            double along = vec2_dot(gaps[i].normal, gaps[j].normal);
            if (along > 0)
                sum += (reach - gaps[j].gap) * along * along;
        }
        gaps[i].share = (reach - gaps[i].gap) / sum;
    }
}

/* Returns the distance of `local` from the core, and the nearest point of the core. Inside the core the nearest side
 * decides, and the distance is negative. */
static double core_distance(const Body *body, Vec2 local, Vec2 *nearest, Vec2 *normal) {
    Vec2 low = body->core_low, high = body->core_high;
    *nearest = vec2(real_max(low.x, real_min(high.x, local.x)), real_max(low.y, real_min(high.y, local.y)));
    Vec2 off = vec2_sub(*nearest, local);
    double distance = vec2_length(off);
    if (distance > 0) {
        *normal = vec2_scale(off, 1 / distance);
        return distance;
    }
    double depth[4] = {local.x - low.x, high.x - local.x, local.y - low.y, high.y - local.y};
    static const Vec2 towards[4] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int least = 0;
    for (int i = 1; i < 4; i++)
        if (depth[i] < depth[least])
            least = i;
    *normal = towards[least];
    *nearest = vec2_along(local, -depth[least], towards[least]);
    return -depth[least];
}

static bool is_held(const int *held, size_t held_count, int key) {
    for (size_t k = 0; k < held_count; k++)
        if (held[k] == key)
            return true;
    return false;
}

static size_t gaps_to_face(Gap *gaps, size_t count, const Stance *stance, const NeighbourFace *face, const int *held,
                           size_t held_count) {
    const Body *body = stance->body;
    Vec2 tangent = vec2_left(face->normal);
    for (int c = 0; c < body->core_count; c++) {
        Vec2 corner = vec2_add(stance->centre, stance->core[c]);
        double distance = vec2_dot(face->normal, corner) - face->offset, along = vec2_dot(tangent, corner);
        int key = face->id * PARTS + c;
        bool deep = distance <= -face->depth;
        if (distance - body->radius >= body->sight || along < face->begin || along > face->end ||
            (deep && !is_held(held, held_count, key)))
            continue;
        count = add_gap(gaps, count,
                        (Gap){.gap = distance - body->radius,
                              .normal = face->normal,
                              .arm = vec2_along(stance->core[c], -distance, face->normal),
                              .key = key,
                              .deep = deep});
    }
    return count;
}

/* Drops gaps to the far side of a solid: a corner that has sunk deep behind a face is past the middle of the solid, so
 * the forces of the far side would push it through. */
static size_t drop_far_sides(Gap *gaps, size_t count) {
    for (size_t d = 0; d < count; d++)
        for (size_t g = 0; gaps[d].deep && g < count; g++)
            if (gaps[g].key % PARTS == gaps[d].key % PARTS && vec2_dot(gaps[g].normal, gaps[d].normal) < 0) {
                gaps[g] = gaps[--count];
                d = g = 0;
            }
    return count;
}

static size_t gap_to_corner(Gap *gaps, size_t count, const Stance *stance, const NeighbourCorner *corner) {
    const Body *body = stance->body;
    Vec2 arm = vec2_sub(corner->at, stance->centre), local = vec2_unturn(arm, stance->axis), nearest, normal;
    double gap = core_distance(body, local, &nearest, &normal) - body->radius;
    if (gap >= body->sight)
        return count;
    Vec2 outwards = vec2_turn(normal, stance->axis);
    if (vec2_dot(outwards, corner->in) < 0 || vec2_dot(outwards, corner->out) > 0)
        return count; /* a face is nearer */
    return add_gap(gaps, count,
                   (Gap){.gap = gap, .normal = outwards, .arm = arm, .key = corner->id * PARTS + PART_SIDE});
}

size_t gap_to_obstacles(Gap gaps[GAPS_MOST], const Body *body, Vec2 centre, Vec2 axis, const NeighbourList *neighbours,
                        const int *held, size_t held_count) {
    Stance stance;
    body_stance(&stance, body, centre, axis);
    size_t count = 0;
    for (int i = 0; i < neighbours->close_faces; i++)
        count = gaps_to_face(gaps, count, &stance, &neighbours->face[neighbours->close_face[i]], held, held_count);
    for (int i = 0; i < neighbours->close_corners; i++)
        count = gap_to_corner(gaps, count, &stance, &neighbours->corner[neighbours->close_corner[i]]);
    if (held_count)
        count = drop_far_sides(gaps, count);
    fill_shares(gaps, count, body->sight);
    return count;
}

size_t gap_of_disc(Gap gaps[GAPS_MOST], Vec2 centre, double radius, double sight, const NeighbourFace *const *faces,
                   size_t face_count, const NeighbourCorner *const *corners, size_t corner_count, const int *held,
                   size_t held_count) {
    size_t count = 0;
    for (size_t f = 0; f < face_count; f++) {
        const NeighbourFace *face = faces[f];
        double distance = vec2_dot(face->normal, centre) - face->offset;
        double along = vec2_dot(vec2_left(face->normal), centre);
        bool deep = distance <= -face->depth;
        int key = face->id * PARTS;
        if (distance - radius < sight && along >= face->begin && along <= face->end &&
            (!deep || is_held(held, held_count, key)))
            count = add_gap(gaps, count,
                            (Gap){.gap = distance - radius,
                                  .normal = face->normal,
                                  .arm = vec2_scale(face->normal, -distance),
                                  .key = key,
                                  .deep = deep});
    }
    for (size_t c = 0; c < corner_count; c++) {
        Vec2 from = vec2_sub(centre, corners[c]->at);
        double distance = vec2_length(from);
        if (distance - radius >= sight || distance <= 0)
            continue;
        Vec2 outwards = vec2_scale(from, 1 / distance);
        if (vec2_dot(outwards, corners[c]->in) >= 0 && vec2_dot(outwards, corners[c]->out) <= 0)
            count = add_gap(gaps, count,
                            (Gap){.gap = distance - radius,
                                  .normal = outwards,
                                  .arm = vec2_scale(from, -1),
                                  .key = corners[c]->id * PARTS + PART_SIDE});
    }
    if (held_count)
        count = drop_far_sides(gaps, count);
    fill_shares(gaps, count, sight);
    return count;
}

/* Adds the gaps of a's core corners to b's core; normals point to a. */
static size_t gaps_of_corners(Gap *gaps, size_t count, const Stance *a, const Stance *b, double reach, bool swapped) {
    double radii = a->body->radius + b->body->radius;
    for (int c = 0; c < a->body->core_count; c++) {
        Vec2 corner = vec2_add(a->centre, a->core[c]), nearest, normal;
        Vec2 local = vec2_unturn(vec2_sub(corner, b->centre), b->axis);
        double gap = core_distance(b->body, local, &nearest, &normal) - radii;
        if (gap >= reach)
            continue;
        Vec2 from_b = vec2_scale(vec2_turn(normal, b->axis), -1);
        Vec2 meeting = vec2_along(corner, -(a->body->radius + gap / 2), from_b);
        count = add_gap(gaps, count,
                        (Gap){.gap = gap,
                              .normal = swapped ? vec2_scale(from_b, -1) : from_b,
                              .arm = vec2_sub(meeting, swapped ? b->centre : a->centre),
                              .key = c + (swapped ? PART_SIDE : 0)});
    }
    return count;
}

size_t gap_to_body(Gap gaps[GAPS_MOST], const Body *a, Vec2 centre_a, Vec2 axis_a, const Body *b, Vec2 centre_b,
                   Vec2 axis_b, double reach) {
    Stance stance_a, stance_b;
    body_stance(&stance_a, a, centre_a, axis_a);
    body_stance(&stance_b, b, centre_b, axis_b);
    size_t count = gaps_of_corners(gaps, 0, &stance_a, &stance_b, reach, false);
    if (b->core_count > 1 || a->core_count > 1)
        count = gaps_of_corners(gaps, count, &stance_b, &stance_a, reach, true);
    fill_shares(gaps, count, reach);
    return count;
}

Vec2 gap_force(const ContactLaw *law, const Gap *gap, double compression_gap, double rate, double sliding, double dt,
               double *slip, double *normal) {
    *normal = contact_normal(law, compression_gap, rate) * gap->share;
    if (*normal <= 0) {
        *slip = 0;
        return vec2(0, 0);
    }
    ContactLaw shared = *law;
    shared.tangential_stiffness *= gap->share;
    shared.tangential_damping *= gap->share;
    double along = contact_tangential(&shared, *normal, sliding, dt, slip);
    return vec2_along(vec2_scale(gap->normal, *normal), along, vec2_left(gap->normal));
}
