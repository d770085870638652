#include "space/neighbour_list.h"

/* m: contact treats every solid as at most this thick. */
static const double DEEPEST = 0.05;

/* Returns how deep a body may sink behind a face before it is on the other side: half of the solid. */
static double face_depth(const Plan *plan, const Face *face) {
    switch ((Owner)face->owner) {
    case OWNER_WALL:
        return fmin(plan->walls[face->index].thickness / 2, DEEPEST);
    case OWNER_DOOR:
        return fmin(plan->doors[face->index].leaf / 2, DEEPEST);
    case OWNER_FURNITURE:
        return fmin(fmin(plan->furniture[face->index].size.x, plan->furniture[face->index].size.y) / 2, DEEPEST);
    }
    return DEEPEST;
}

NeighbourFace neighbour_list_face(const Outline *outline, const Plan *plan, size_t index) {
    const Face *face = &outline->faces[index];
    Vec2 tangent = vec2_left(face->normal); /* from a to b: the solid is on its left */
    return (NeighbourFace){.normal = face->normal,
                           .offset = vec2_dot(face->normal, face->a),
                           .begin = vec2_dot(tangent, face->a),
                           .end = vec2_dot(tangent, face->b),
                           .depth = face_depth(plan, face),
                           .id = (int)index};
}

NeighbourCorner neighbour_list_corner(const Outline *outline, size_t index) {
    const Corner *corner = &outline->corners[index];
    return (NeighbourCorner){
        .at = corner->at, .in = corner->in, .out = corner->out, .id = (int)(outline->face_count + index)};
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
    Candidate candidate[2 * NEIGHBOURS_MOST];
    int count;
} Gathering;

static bool is_nearer(Candidate a, Candidate b) {
    return a.distance < b.distance || (a.distance == b.distance && a.item < b.item);
}

/* Inserts the candidate in order. If there are too many, the farthest is dropped, so that the result does not depend on
 * the order of the tree. */
static bool gather(void *context, int item) {
    Gathering *gathering = context;
    const Outline *outline = gathering->outline;
    Candidate candidate = {.item = item};
    if ((size_t)item < outline->face_count) {
        const Face *face = &outline->faces[item];
        if (!outline_present(face->door, face->presence, gathering->door_open))
            return true;
        candidate.distance =
            vec2_distance(gathering->centre, vec2_nearest_on_segment(gathering->centre, face->a, face->b));
    } else {
        const Corner *corner = &outline->corners[(size_t)item - outline->face_count];
        if (!outline_present(corner->door, corner->presence, gathering->door_open))
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

static void gather_all(NeighbourList *neighbours, double outer, Vec2 middle, const Outline *outline, const Plan *plan,
                       const bool *door_open) {
    Gathering gathering = {.outline = outline,
                           .door_open = door_open,
                           .centre = middle,
                           .reach = outer + NEIGHBOUR_SKIN + NEIGHBOUR_SLACK};
    broadphase_visit(outline->broadphase, box_around(middle, gathering.reach), gather, &gathering);
    neighbours->centre = middle;
    neighbours->faces = neighbours->corners = 0;
    for (int i = 0; i < gathering.count; i++) {
        size_t item = (size_t)gathering.candidate[i].item;
        if (item < outline->face_count && neighbours->faces < NEIGHBOURS_MOST)
            neighbours->face[neighbours->faces++] = neighbour_list_face(outline, plan, item);
        else if (item >= outline->face_count && neighbours->corners < NEIGHBOURS_MOST)
            neighbours->corner[neighbours->corners++] = neighbour_list_corner(outline, item - outline->face_count);
    }
}

/* True if a corner of the core may be within `reach` of the face. */
static bool face_is_close(const Stance *stance, const NeighbourFace *face, double reach) {
    const Body *body = stance->body;
    Vec2 tangent = vec2_left(face->normal);
    double across = fabs(vec2_dot(face->normal, stance->axis)), beside = fabs(vec2_dot(tangent, stance->axis));
    double deep = across * body->half.x + beside * body->half.y, wide = beside * body->half.x + across * body->half.y;
    double from_middle = vec2_dot(face->normal, stance->middle) - face->offset;
    double along_middle = vec2_dot(tangent, stance->middle), slack = reach - body->sight;
    return from_middle - deep - body->radius < reach && from_middle + deep > -face->depth - slack &&
           along_middle + wide + slack > face->begin && along_middle - wide - slack < face->end;
}

/* True if the core may be within `reach` of the obstacle's corner. */
static bool corner_is_close(const Stance *stance, const NeighbourCorner *corner, double reach) {
    const Body *body = stance->body;
    Vec2 local = vec2_unturn(vec2_sub(corner->at, stance->middle), stance->axis);
    double outer = body->radius + reach;
    return fabs(local.x) < body->half.x + outer && fabs(local.y) < body->half.y + outer;
}

static void choose_close(NeighbourList *neighbours, const Stance *stance) {
    double reach = stance->body->sight + NEIGHBOUR_SLACK;
    neighbours->slack_centre = stance->centre;
    neighbours->slack_axis = stance->axis;
    neighbours->close_faces = neighbours->close_corners = 0;
    for (int i = 0; i < neighbours->faces; i++)
        if (face_is_close(stance, &neighbours->face[i], reach))
            neighbours->close_face[neighbours->close_faces++] = (short)i;
    for (int i = 0; i < neighbours->corners; i++)
        if (corner_is_close(stance, &neighbours->corner[i], reach))
            neighbours->close_corner[neighbours->close_corners++] = (short)i;
}

void neighbour_list_update(NeighbourList *neighbours, const Body *body, Vec2 centre, Vec2 axis, const Outline *outline,
                           const Plan *plan, const bool *door_open, int door_changes) {
    bool same_doors = neighbours->doors == door_changes + 1;
    double moved =
        vec2_distance(centre, neighbours->slack_centre) + vec2_distance(axis, neighbours->slack_axis) * body->swing;
    if (same_doors && moved < NEIGHBOUR_SLACK)
        return;
    Stance stance;
    body_stance(&stance, body, centre, axis);
    if (!same_doors || vec2_distance(neighbours->centre, stance.middle) > NEIGHBOUR_SKIN)
        gather_all(neighbours, body->outer, stance.middle, outline, plan, door_open);
    neighbours->doors = door_changes + 1;
    choose_close(neighbours, &stance);
}
