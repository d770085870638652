#include "house/gap.h"

#include <string.h>

/* m: nothing is thicker to the touch than this, however thick it is. */
static const double DEEPEST = 0.05;
/* The part of a body in a key: its core's corners 0 to 3, or its sides. */
enum { PART_SIDE = 4, PARTS = GAP_PARTS };

Body body_of(const Profile *profile) {
    Body body = {.core_count = 1, .radius = profile->width / 2, .reach = profile->space_reach};
    if (profile->driving == DRIVING_DRIVER) {
        double rear = -profile->axle - profile->mass_centre;
        body.core_count = 4;
        body.radius = profile->corner_radius;
        body.core_low = vec2(rear + body.radius, body.radius - profile->width / 2);
        body.core_high = vec2(rear + profile->length - body.radius, profile->width / 2 - body.radius);
    }
    body.core[0] = body.core_low;
    body.core[1] = vec2(body.core_high.x, body.core_low.y);
    body.core[2] = body.core_high;
    body.core[3] = vec2(body.core_low.x, body.core_high.y);
    body.middle = vec2_scale(vec2_add(body.core_low, body.core_high), 0.5);
    body.half = vec2_scale(vec2_sub(body.core_high, body.core_low), 0.5);
    for (int i = 0; i < 4; i++) {
        body.swing = fmax(body.swing, vec2_length(body.core[i]));
        body.outer = fmax(body.outer, vec2_length(vec2_sub(body.core[i], body.middle)) + body.radius + body.reach);
    }
    return body;
}

/* Neighbours ---------------------------------------------------------------------------------------------------- */

/* How deep a body may sink behind a face before it is on the other side: half of the solid. */
static double face_depth(const Plan *plan, const Face *face) {
    switch ((Owner)face->owner) {
    case OWNER_WALL:
        return fmin(plan->walls[face->index].thickness / 2, DEEPEST);
    case OWNER_DOOR:
        return fmin(OUTLINE_LEAF_THICKNESS / 2, DEEPEST);
    case OWNER_FURNITURE:
        return fmin(fmin(plan->furniture[face->index].size.x, plan->furniture[face->index].size.y) / 2, DEEPEST);
    }
    return DEEPEST;
}

typedef struct Candidate {
    double distance;
    int item;
} Candidate;

typedef struct Gathering {
    const Outline *outline;
    const bool *door_open;
    Vec2 centre;
    double reach;
    Candidate candidate[2 * NEAR_MOST];
    int count;
} Gathering;

static bool is_present(int door, int presence, const bool *door_open) {
    return presence == PRESENT_ALWAYS || door_open[door] == (presence == PRESENT_OPEN);
}

static bool is_nearer(Candidate a, Candidate b) {
    return a.distance < b.distance || (a.distance == b.distance && a.item < b.item);
}

/* Keeps the candidates sorted; when they are too many the farthest falls out, whatever order the tree has. */
static bool gather(void *context, int item) {
    Gathering *gathering = context;
    const Outline *outline = gathering->outline;
    Candidate candidate = {.item = item};
    if ((size_t)item < outline->face_count) {
        const Face *face = &outline->faces[item];
        if (!is_present(face->door, face->presence, gathering->door_open))
            return true;
        candidate.distance =
            vec2_distance(gathering->centre, vec2_nearest_on_segment(gathering->centre, face->a, face->b));
    } else {
        const Corner *corner = &outline->corners[(size_t)item - outline->face_count];
        if (!is_present(corner->door, corner->presence, gathering->door_open))
            return true;
        candidate.distance = vec2_distance(gathering->centre, corner->at);
    }
    if (candidate.distance > gathering->reach)
        return true;
    const int most = sizeof gathering->candidate / sizeof *gathering->candidate;
    if (gathering->count == most && !is_nearer(candidate, gathering->candidate[most - 1]))
        return true;
    int place = gathering->count < most ? gathering->count++ : most - 1;
    while (place > 0 && is_nearer(candidate, gathering->candidate[place - 1])) {
        gathering->candidate[place] = gathering->candidate[place - 1];
        place--;
    }
    gathering->candidate[place] = candidate;
    return true;
}

/* A body as it stands. */
typedef struct Stance {
    const Body *body;
    Vec2 centre, axis;
    Vec2 middle;  /* m, of the core */
    Vec2 core[4]; /* m, the core's corners from the centre */
} Stance;

static Stance stance_of(const Body *body, Vec2 centre, Vec2 axis) {
    Stance stance = {.body = body, .centre = centre, .axis = axis};
    stance.middle = vec2_add(centre, vec2_turn(body->middle, axis));
    for (int i = 0; i < body->core_count; i++)
        stance.core[i] = vec2_turn(body->core[i], axis);
    return stance;
}

static void gather_all(Near *near, double outer, Vec2 middle, const Outline *outline, const Plan *plan,
                       const bool *door_open) {
    Gathering gathering = {
        .outline = outline, .door_open = door_open, .centre = middle, .reach = outer + NEAR_SKIN + NEAR_SLACK};
    broadphase_visit(outline->broadphase, box_around(middle, gathering.reach), gather, &gathering);
    near->centre = middle;
    near->faces = near->corners = 0;
    for (int i = 0; i < gathering.count; i++) {
        size_t item = (size_t)gathering.candidate[i].item;
        if (item < outline->face_count && near->faces < NEAR_MOST) {
            const Face *face = &outline->faces[item];
            Vec2 tangent = vec2_left(face->normal); /* from a to b: the solid is on its left */
            near->face[near->faces++] = (NearFace){.normal = face->normal,
                                                   .offset = vec2_dot(face->normal, face->a),
                                                   .begin = vec2_dot(tangent, face->a),
                                                   .end = vec2_dot(tangent, face->b),
                                                   .depth = face_depth(plan, face),
                                                   .id = (int)item};
        } else if (item >= outline->face_count && near->corners < NEAR_MOST) {
            const Corner *corner = &outline->corners[item - outline->face_count];
            near->corner[near->corners++] =
                (NearCorner){.at = corner->at, .in = corner->in, .out = corner->out, .id = (int)item};
        }
    }
}

/* May a corner of the core be within `reach` of the face? */
static bool face_is_close(const Stance *stance, const NearFace *face, double reach) {
    const Body *body = stance->body;
    Vec2 tangent = vec2_left(face->normal);
    double across = fabs(vec2_dot(face->normal, stance->axis)), beside = fabs(vec2_dot(tangent, stance->axis));
    double deep = across * body->half.x + beside * body->half.y, wide = beside * body->half.x + across * body->half.y;
    double from_middle = vec2_dot(face->normal, stance->middle) - face->offset;
    double along_middle = vec2_dot(tangent, stance->middle), slack = reach - body->reach;
    return from_middle - deep - body->radius < reach && from_middle + deep > -face->depth - slack &&
           along_middle + wide + slack > face->begin && along_middle - wide - slack < face->end;
}

/* May the core be within `reach` of the obstacle's corner? */
static bool corner_is_close(const Stance *stance, const NearCorner *corner, double reach) {
    const Body *body = stance->body;
    Vec2 local = vec2_unturn(vec2_sub(corner->at, stance->middle), stance->axis);
    double outer = body->radius + reach;
    return fabs(local.x) < body->half.x + outer && fabs(local.y) < body->half.y + outer;
}

static void choose_close(Near *near, const Stance *stance) {
    double reach = stance->body->reach + NEAR_SLACK;
    near->slack_centre = stance->centre;
    near->slack_axis = stance->axis;
    near->close_faces = near->close_corners = 0;
    for (int i = 0; i < near->faces; i++)
        if (face_is_close(stance, &near->face[i], reach))
            near->close_face[near->close_faces++] = (short)i;
    for (int i = 0; i < near->corners; i++)
        if (corner_is_close(stance, &near->corner[i], reach))
            near->close_corner[near->close_corners++] = (short)i;
}

void near_update(Near *near, const Body *body, Vec2 centre, Vec2 axis, const Outline *outline, const Plan *plan,
                 const bool *door_open, int door_changes) {
    bool same_doors = near->doors == door_changes + 1;
    double moved = vec2_distance(centre, near->slack_centre) + vec2_distance(axis, near->slack_axis) * body->swing;
    if (same_doors && moved < NEAR_SLACK)
        return;
    Stance stance = stance_of(body, centre, axis);
    if (!same_doors || vec2_distance(near->centre, stance.middle) > NEAR_SKIN)
        gather_all(near, body->outer, stance.middle, outline, plan, door_open);
    near->doors = door_changes + 1;
    choose_close(near, &stance);
}

/* Gaps ------------------------------------------------------------------------------------------------------------- */

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

/* The outside distance of `local` from the core, and the nearest point of the core. Inside the core the nearest side
 * decides and the distance is negative. */
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

static size_t gaps_to_face(Gap *gaps, size_t count, const Stance *stance, const NearFace *face) {
    const Body *body = stance->body;
    Vec2 tangent = vec2_left(face->normal);
    for (int c = 0; c < body->core_count; c++) {
        Vec2 corner = vec2_add(stance->centre, stance->core[c]);
        double distance = vec2_dot(face->normal, corner) - face->offset, along = vec2_dot(tangent, corner);
        double gap = distance - body->radius;
        if (gap < body->reach && distance > -face->depth && along >= face->begin && along <= face->end)
            count = add_gap(gaps, count,
                            (Gap){.gap = gap,
                                  .normal = face->normal,
                                  .arm = vec2_along(stance->core[c], -distance, face->normal),
                                  .key = face->id * PARTS + c});
    }
    return count;
}

static size_t gap_to_corner(Gap *gaps, size_t count, const Stance *stance, const NearCorner *corner) {
    const Body *body = stance->body;
    Vec2 arm = vec2_sub(corner->at, stance->centre), local = vec2_unturn(arm, stance->axis), nearest, normal;
    double gap = core_distance(body, local, &nearest, &normal) - body->radius;
    if (gap >= body->reach)
        return count;
    Vec2 outwards = vec2_turn(normal, stance->axis);
    if (vec2_dot(outwards, corner->in) < 0 || vec2_dot(outwards, corner->out) > 0)
        return count; /* a face is nearer */
    return add_gap(gaps, count,
                   (Gap){.gap = gap, .normal = outwards, .arm = arm, .key = corner->id * PARTS + PART_SIDE});
}

size_t gap_to_obstacles(Gap gaps[GAPS_MOST], const Body *body, Vec2 centre, Vec2 axis, const Near *near) {
    Stance stance = stance_of(body, centre, axis);
    size_t count = 0;
    for (int i = 0; i < near->close_faces; i++)
        count = gaps_to_face(gaps, count, &stance, &near->face[near->close_face[i]]);
    for (int i = 0; i < near->close_corners; i++)
        count = gap_to_corner(gaps, count, &stance, &near->corner[near->close_corner[i]]);
    fill_shares(gaps, count, body->reach);
    return count;
}

/* The gaps of a's core corners to b's core; normals point to a. */
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
    Stance stance_a = stance_of(a, centre_a, axis_a), stance_b = stance_of(b, centre_b, axis_b);
    size_t count = gaps_of_corners(gaps, 0, &stance_a, &stance_b, reach, false);
    if (b->core_count > 1 || a->core_count > 1)
        count = gaps_of_corners(gaps, count, &stance_b, &stance_a, reach, true);
    fill_shares(gaps, count, reach);
    return count;
}
