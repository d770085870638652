#include "space/outline.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "space/solids.h"

/* 1: sine of the angle below which a ray runs along a face rather than into it. */
static const double GRAZING = 1e-5;

typedef struct Builder {
    Outline *outline;
    const Plan *plan;
    Solids solids;
    size_t face_capacity, corner_capacity;
} Builder;

/* Faces ------------------------------------------------------------------------------------------------------- */

static void add_face(Builder *builder, Face face) {
    Outline *outline = builder->outline;
    face.normal = vec2_scale(vec2_left(vec2_unit(vec2_sub(face.b, face.a))), -1);
    outline->faces =
        memory_reserve(outline->faces, &builder->face_capacity, outline->face_count + 1, sizeof *outline->faces);
    outline->faces[outline->face_count++] = face;
}

static void add_corner(Builder *builder, Corner corner) {
    Outline *outline = builder->outline;
    outline->corners = memory_reserve(outline->corners, &builder->corner_capacity, outline->corner_count + 1,
                                      sizeof *outline->corners);
    outline->corners[outline->corner_count++] = corner;
}

/* Adds the faces and convex corners of a closed ring (its first point not repeated) whose solid is on the left. */
static void add_ring(Builder *builder, const Vec2 *ring, size_t count) {
    size_t first = builder->outline->face_count;
    for (size_t i = 0; i < count; i++) {
        Vec2 a = ring[i], b = ring[(i + 1) % count];
        const Solid *owner = solids_owner(&builder->solids, vec2_scale(vec2_add(a, b), 0.5));
        add_face(builder, (Face){.a = a,
                                 .b = b,
                                 .owner = owner ? owner->owner : OWNER_WALL,
                                 .index = owner ? owner->index : 0,
                                 .door = -1});
    }
    for (size_t i = 0; i < count; i++) {
        const Face *face = &builder->outline->faces[first + i];
        const Face *before = &builder->outline->faces[first + (i + count - 1) % count];
        Vec2 in = vec2_unit(vec2_sub(before->b, before->a)), out = vec2_unit(vec2_sub(face->b, face->a));
        bool end = fabs(vec2_cross(in, out)) <= SOLIDS_STRAIGHT && vec2_dot(in, out) < 0; /* of a thin wall */
        if (vec2_cross(in, out) > SOLIDS_STRAIGHT || end)
            add_corner(
                builder,
                (Corner){.at = face->a, .in = in, .out = out, .owner = face->owner, .index = face->index, .door = -1});
    }
}

static void add_rings(Builder *builder, const Rings *rings) {
    for (size_t r = 0; r < rings->count; r++)
        add_ring(builder, rings->points + rings->starts[r], rings->starts[r + 1] - rings->starts[r]);
}

/* Adds both sides of a thin wall's lines. */
static void add_thin_lines(Builder *builder, const GEOSGeometry *geometry) {
    GEOSContextHandle_t geos = builder->solids.geos;
    int type = GEOSGeomTypeId_r(geos, geometry);
    if (type == GEOS_LINESTRING || type == GEOS_LINEARRING) {
        const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(geos, geometry);
        unsigned size = 0;
        GEOSCoordSeq_getSize_r(geos, sequence, &size);
        if (size < 2)
            return;
        size_t count = 2 * (size_t)size - 2;
        Vec2 *ring = memory_zeroed(count, sizeof *ring);
        for (unsigned i = 0; i < size; i++) {
            GEOSCoordSeq_getXY_r(geos, sequence, i, &ring[i].x, &ring[i].y);
            if (i > 0 && i + 1 < size)
                ring[count - i] = ring[i];
        }
        add_ring(builder, ring, count);
        memory_free(ring);
    } else {
        for (int i = 0; type != GEOS_POINT && i < GEOSGetNumGeometries_r(geos, geometry); i++)
            add_thin_lines(builder, GEOSGetGeometryN_r(geos, geometry, i));
    }
}

static void add_thin_walls(Builder *builder, const GEOSGeometry *united) {
    for (size_t w = 0; w < builder->plan->wall_count; w++) {
        if (builder->plan->walls[w].thickness > 0)
            continue;
        GEOSGeometry *rest = solids_thin_wall(&builder->solids, w, united);
        if (rest)
            add_thin_lines(builder, rest);
        GEOSGeom_destroy_r(builder->solids.geos, rest);
    }
}

/* Adds the leaf of a door that can be opened, both shut (two faces; its ends are in the wall) and open (its root is).
 */
static void add_moving_leaf(Builder *builder, size_t d) {
    const Plan *plan = builder->plan;
    const Door *door = &plan->doors[d];
    Vec2 from, to, corners[4];
    plan_geometry_door_ends(plan, door, &from, &to);
    solids_strip(from, to, door->leaf / 2, door->leaf / 2, corners);
    Face face = {.owner = OWNER_DOOR, .index = (int)d, .door = (int)d, .presence = PRESENT_SHUT};
    for (int side = 0; side < 4; side += 2) {
        face.a = corners[side];
        face.b = corners[side + 1];
        add_face(builder, face);
    }
    bool rests = door->kind == DOOR_SLIDING && door->rest > 0;
    if (door->kind != DOOR_HINGED && !rests)
        return;
    if (rests)
        solids_rest(plan, door, corners);
    else
        solids_open_leaf(plan, door, plan->walls[door->wall_index].thickness / 2, corners);
    face.presence = PRESENT_OPEN;
    for (int i = 0; i < 3; i++) { /* side, free end, side */
        face.a = corners[i];
        face.b = corners[i + 1];
        add_face(builder, face);
        if (i > 0)
            add_corner(builder, (Corner){.at = corners[i],
                                         .in = vec2_unit(vec2_sub(corners[i], corners[i - 1])),
                                         .out = vec2_unit(vec2_sub(corners[i + 1], corners[i])),
                                         .owner = OWNER_DOOR,
                                         .index = (int)d,
                                         .door = (int)d,
                                         .presence = PRESENT_OPEN});
    }
}

/* The whole ------------------------------------------------------------------------------------------------------ */

static Box plan_box(const Plan *plan, const Outline *outline) {
    Box box = box_empty();
    for (size_t i = 0; i < outline->face_count; i++)
        box = box_include(box_include(box, outline->faces[i].a), outline->faces[i].b);
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t i = 0; i < plan->walls[w].points.count; i++)
            box = box_include(box, plan->walls[w].points.at[i]);
    for (size_t e = 0; e < plan->exit_count; e++)
        box = box_include(box_include(box, plan->exits[e].from), plan->exits[e].to);
    for (size_t p = 0; p < plan->person_count; p++)
        box = box_include(box, plan->people[p].at);
    for (size_t c = 0; c < plan->crowd_count; c++)
        for (size_t i = 0; i < plan->crowds[c].area.count; i++)
            box = box_include(box, plan->crowds[c].area.at[i]);
    for (size_t r = 0; r < plan->route_count; r++)
        for (size_t i = 0; i < plan->routes[r].via.count; i++)
            box = box_include(box, plan->routes[r].via.at[i]);
    return box.low.x <= box.high.x ? box : (Box){{0, 0}, {1, 1}};
}

static void fill_broadphase(Outline *outline) {
    outline->broadphase = broadphase_create();
    for (size_t i = 0; i < outline->face_count; i++)
        broadphase_insert(outline->broadphase,
                          box_include(box_include(box_empty(), outline->faces[i].a), outline->faces[i].b), (int)i);
    for (size_t j = 0; j < outline->corner_count; j++)
        broadphase_insert(outline->broadphase, box_around(outline->corners[j].at, 0), (int)(outline->face_count + j));
}

static bool build(Builder *builder) {
    const Plan *plan = builder->plan;
    GEOSGeometry *united = solids_unite(&builder->solids);
    if (!united)
        return false;
    solids_add_rings(&builder->solids, united, &builder->outline->rings);
    add_rings(builder, &builder->outline->rings);
    add_thin_walls(builder, united);
    GEOSGeom_destroy_r(builder->solids.geos, united);
    for (size_t d = 0; d < plan->door_count; d++)
        if (outline_door_moves(&plan->doors[d]))
            add_moving_leaf(builder, d);
    return true;
}

bool outline_build(Outline *outline, const Plan *plan, Fault *fault) {
    Outline built = {.faces = NULL};
    Builder builder = {.outline = &built, .plan = plan};
    solids_init(&builder.solids, plan);
    bool good = build(&builder);
    if (good) {
        built.box = plan_box(plan, &built);
        fill_broadphase(&built);
        outline_free(outline);
        *outline = built;
    } else {
        fault_add(fault, "%s:1:1: the walls cannot be united: %s", plan->path, builder.solids.message);
        outline_free(&built);
    }
    solids_clear(&builder.solids);
    return good;
}

bool outline_walls(const Plan *plan, double low, double high, Rings *rings) {
    Solids solids;
    solids_init(&solids, plan);
    GEOSGeometry *walls = solids_unite_walls(&solids, low, high);
    *rings = (Rings){.count = 0};
    if (walls)
        solids_add_rings(&solids, walls, rings);
    GEOSGeom_destroy_r(solids.geos, walls);
    solids_clear(&solids);
    return walls;
}

void outline_free_rings(Rings *rings) {
    memory_free(rings->points);
    memory_free(rings->starts);
    *rings = (Rings){.count = 0};
}

void outline_free(Outline *outline) {
    memory_free(outline->faces);
    memory_free(outline->corners);
    outline_free_rings(&outline->rings);
    if (outline->broadphase)
        broadphase_destroy(outline->broadphase);
    *outline = (Outline){0};
}

/* Rays and names ------------------------------------------------------------------------------------------------- */

typedef struct RayContext {
    const Outline *outline;
    const bool *door_open; /* NULL: planned state */
    int face;              /* the face met, or -1 */
} RayContext;

static bool meets(const RayContext *ray, const Face *face) {
    return ray->door_open ? outline_present(face->door, face->presence, ray->door_open)
                          : outline_planned(face->presence);
}

static double ray_hit(void *context, int item, Vec2 from, Vec2 to, double best) {
    RayContext *ray = context;
    if ((size_t)item >= ray->outline->face_count || !meets(ray, &ray->outline->faces[item]))
        return best;
    const Face *face = &ray->outline->faces[item];
    Vec2 along = vec2_sub(to, from), side = vec2_sub(face->b, face->a), offset = vec2_sub(face->a, from);
    double turn = vec2_cross(along, side);
    if (fabs(turn) < GRAZING * vec2_length(along) *
                         vec2_length(side)) /* the ray runs along the face: a neighbouring face ends the ray */
        return best;
    double t = vec2_cross(offset, side) / turn, s = vec2_cross(offset, along) / turn;
    if (t < 0 || t >= best || s < 0 || s > 1)
        return best;
    ray->face = item;
    return t;
}

double outline_ray(const Outline *outline, Vec2 from, Vec2 direction, double reach, int *face) {
    RayContext context = {.outline = outline, .face = -1};
    double fraction = broadphase_ray(outline->broadphase, from, vec2_along(from, reach, direction), ray_hit, &context);
    if (face)
        *face = context.face;
    return fraction * reach;
}

double outline_ray_past(const Outline *outline, const bool *door_open, Vec2 from, Vec2 direction, double reach) {
    RayContext context = {.outline = outline, .door_open = door_open, .face = -1};
    return reach * broadphase_ray(outline->broadphase, from, vec2_along(from, reach, direction), ray_hit, &context);
}

void outline_name(const Plan *plan, int owner, int index, char *name, size_t size) {
    switch ((Owner)owner) {
    case OWNER_WALL:
        snprintf(name, size, "%s %s", plan->walls[index].closed_exit ? "closed exit" : "wall", plan->walls[index].id);
        break;
    case OWNER_DOOR:
        snprintf(name, size, "%sdoor %s", plan->doors[index].state == DOOR_LOCKED ? "locked " : "",
                 plan->doors[index].id);
        break;
    case OWNER_FURNITURE: {
        const Furniture *piece = &plan->furniture[index];
        if (!*piece->name)
            snprintf(name, size, "furniture %s", piece->id);
        else if (strcmp(piece->name, piece->id) == 0)
            snprintf(name, size, "%s", piece->name);
        else
            snprintf(name, size, "%s (%s)", piece->name, piece->id);
        break;
    }
    }
}

typedef struct NearestContext {
    const Outline *outline;
    Vec2 at;
    int face;
    double distance;
} NearestContext;

static bool visit_nearest(void *context, int item) {
    NearestContext *nearest = context;
    if ((size_t)item >= nearest->outline->face_count || !outline_planned(nearest->outline->faces[item].presence))
        return true;
    const Face *face = &nearest->outline->faces[item];
    double distance = vec2_distance(nearest->at, vec2_nearest_on_segment(nearest->at, face->a, face->b));
    if (distance < nearest->distance || (distance == nearest->distance && item < nearest->face)) {
        nearest->distance = distance;
        nearest->face = item;
    }
    return true;
}

int outline_door_at(const Plan *plan, Vec2 at) {
    const double beside_door = 0.35; /* m: distance of a body's middle from a door's line while it passes */
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        if (vec2_distance(at, vec2_nearest_on_segment(at, from, to)) < beside_door)
            return (int)d;
    }
    return -1;
}

void outline_place_name(const Outline *outline, const Plan *plan, Vec2 at, char *name, size_t size) {
    int door = outline_door_at(plan, at);
    if (door >= 0) {
        outline_name(plan, OWNER_DOOR, door, name, size);
        return;
    }
    NearestContext nearest = {outline, at, -1, HUGE_VAL};
    for (double reach = 0.5; nearest.face < 0 && reach < 100; reach *= 4)
        broadphase_visit(outline->broadphase, box_around(at, reach), visit_nearest, &nearest);
    if (nearest.face < 0)
        snprintf(name, size, OUTLINE_FREE_SPACE);
    else
        outline_name(plan, outline->faces[nearest.face].owner, outline->faces[nearest.face].index, name, size);
}
