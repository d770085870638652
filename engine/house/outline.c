#include "house/outline.h"

#define GEOS_USE_ONLY_R_API
#include <geos_c.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"

/* m: coordinates are united on a grid this fine, so that walls that nearly meet do meet. */
static const double UNION_GRID = 1e-6;
/* m: how near an edge's middle must be to a solid to belong to it, a few steps of the grid. */
static const double OWNER_TOLERANCE = 1e-5;
/* 1: the sine of the turn below which two edges count as one straight face. */
static const double STRAIGHT = 1e-5;
/* 1: the sine of the angle below which a ray runs along a face rather than into it. */
static const double GRAZING = 1e-5;
/* 1: the sine of the angle up to which two walls go straight on. */
static const double COLLINEAR = 0.05;
/* 1: mitred joints of walls reach at most this many half thicknesses. */
static const double MITRE_LIMIT = 5;
/* m: ends of walls this near to each other meet. */
static const double END_TOLERANCE = 1e-6;
/* m: a wall whose last point is this near to its first is closed. */
static const double CLOSED_TOLERANCE = 1e-9;

enum {
    /* Pieces of wall or furniture whose boxes meet, each pair seen from both sides. Each may be a crossing, of which a
     * thousand take some 0.1 s and 5 MB to unite; 100,000 walls that meet at their ends are as many pairs. */
    MOST_MEETINGS = 400000,
    MOST_NEAR = 100 * MOST_MEETINGS /* that have to be looked at for it, some seconds */
};

/* A solid before the union, to tell afterwards to whom a face belongs. */
typedef struct Solid {
    Vec2 corners[4]; /* of a convex quadrangle, counter-clockwise */
    int owner, index;
} Solid;

typedef struct Builder {
    Outline *outline;
    const Plan *plan;
    GEOSContextHandle_t geos;
    char message[160]; /* the last thing that GEOS complained about */
    bool failed;
    GEOSGeometry **parts;
    size_t part_count, part_capacity;
    Solid *solids;
    size_t solid_count, solid_capacity;
    Broadphase *near_solids;
    int *near; /* (near_capacity) what a query has found */
    size_t near_capacity;
    size_t *door_starts;   /* (wall_count + 1) of each wall in doors_of_wall */
    size_t *doors_of_wall; /* (door_count) wall by wall */
    size_t face_capacity, corner_capacity, ring_capacity, ring_point_capacity;
} Builder;

static void remember_message(const char *message, void *context) {
    Builder *builder = context;
    snprintf(builder->message, sizeof builder->message, "%s", message);
}

/* Solids ------------------------------------------------------------------------------------------------------ */

static GEOSGeometry *line_of(const Builder *builder, const Vec2 *points, size_t count, bool ring) {
    GEOSCoordSequence *sequence = GEOSCoordSeq_create_r(builder->geos, (unsigned)count, 2);
    for (size_t i = 0; i < count; i++)
        GEOSCoordSeq_setXY_r(builder->geos, sequence, (unsigned)i, points[i].x, points[i].y);
    return ring ? GEOSGeom_createLinearRing_r(builder->geos, sequence)
                : GEOSGeom_createLineString_r(builder->geos, sequence);
}

static GEOSGeometry *polygon_of(const Builder *builder, const Vec2 corners[4]) {
    Vec2 closed[5] = {corners[0], corners[1], corners[2], corners[3], corners[0]};
    return GEOSGeom_createPolygon_r(builder->geos, line_of(builder, closed, 5, true), NULL, 0);
}

static void add_part(Builder *builder, GEOSGeometry *part) {
    if (!part) {
        builder->failed = true; /* a wall less would be a way out that is not there */
        return;
    }
    builder->parts =
        memory_reserve(builder->parts, &builder->part_capacity, builder->part_count + 1, sizeof *builder->parts);
    builder->parts[builder->part_count++] = part;
}

static Box box_of_corners(const Vec2 corners[4]) {
    Box box = box_empty();
    for (int i = 0; i < 4; i++)
        box = box_include(box, corners[i]);
    return box;
}

/* The broad phase's box is larger by `grown` m, for corners that are not known yet. */
static void add_solid(Builder *builder, const Vec2 corners[4], double grown, int owner, size_t index) {
    builder->solids =
        memory_reserve(builder->solids, &builder->solid_capacity, builder->solid_count + 1, sizeof *builder->solids);
    Solid *solid = &builder->solids[builder->solid_count];
    memcpy(solid->corners, corners, sizeof solid->corners);
    solid->owner = owner;
    solid->index = (int)index;
    broadphase_insert(builder->near_solids, box_expand(box_of_corners(corners), grown), (int)builder->solid_count++);
}

/* How many solids' boxes meet the box; builder->near lists them in rising order. */
static size_t find_near(Builder *builder, Box box) {
    size_t found = broadphase_query(builder->near_solids, box, builder->near, builder->near_capacity);
    if (found > builder->near_capacity) {
        builder->near = memory_reserve(builder->near, &builder->near_capacity, found, sizeof *builder->near);
        broadphase_query(builder->near_solids, box, builder->near, found);
    }
    return found;
}

/* The rectangle from a to b, `left` m to the left of that line and `right` m to its right, counter-clockwise. */
static void strip(Vec2 a, Vec2 b, double left, double right, Vec2 corners[4]) {
    Vec2 side = vec2_left(vec2_unit(vec2_sub(b, a)));
    corners[0] = vec2_along(a, -right, side);
    corners[1] = vec2_along(b, -right, side);
    corners[2] = vec2_along(b, left, side);
    corners[3] = vec2_along(a, left, side);
}

static bool is_closed(const Wall *wall) {
    const Points *points = &wall->points;
    return points->count > 3 && vec2_distance(points->at[0], points->at[points->count - 1]) < CLOSED_TOLERANCE;
}

/* The pieces of the wall between its points, as wide as it is thick. */
static void add_wall_solids(Builder *builder, size_t w) {
    const Wall *wall = &builder->plan->walls[w];
    double half = wall->thickness / 2;
    for (size_t s = 0; s + 1 < wall->points.count; s++) {
        Vec2 corners[4];
        strip(wall->points.at[s], wall->points.at[s + 1], half, half, corners);
        add_solid(builder, corners, half, OWNER_WALL, w); /* its ends may reach on by half */
    }
}

static bool ends_at_an_angle(const Wall *wall, Vec2 end, Vec2 along) {
    const Points *points = &wall->points;
    for (int last = 0; last < 2 && !is_closed(wall); last++) {
        Vec2 at = points->at[last ? points->count - 1 : 0], inner = points->at[last ? points->count - 2 : 1];
        if (vec2_distance(at, end) < END_TOLERANCE &&
            fabs(vec2_cross(along, vec2_unit(vec2_sub(inner, at)))) > COLLINEAR)
            return true;
    }
    return false;
}

/* Does another wall end where this one does, and at an angle to `along`, its direction there? Then both reach on by
 * half their thickness and close the corner; walls that go straight on need not, and a door may begin there. */
static bool meets_an_end(Builder *builder, size_t wall, Vec2 end, Vec2 along) {
    size_t found = find_near(builder, box_around(end, END_TOLERANCE));
    for (size_t i = 0; i < found; i++) {
        const Solid *solid = &builder->solids[builder->near[i]];
        if (solid->owner == OWNER_WALL && (size_t)solid->index != wall &&
            ends_at_an_angle(&builder->plan->walls[solid->index], end, along))
            return true;
    }
    return false;
}

static void sort_doors(Builder *builder) {
    const Plan *plan = builder->plan;
    size_t *starts = memory_allocate(plan->wall_count + 2, sizeof *starts);
    size_t *sorted = memory_allocate(plan->door_count, sizeof *sorted);
    for (size_t d = 0; d < plan->door_count; d++)
        starts[plan->doors[d].wall_index + 2]++;
    for (size_t w = 2; w < plan->wall_count + 2; w++)
        starts[w] += starts[w - 1];
    for (size_t d = 0; d < plan->door_count; d++) /* which turns the starts of the next wall into its own */
        sorted[starts[plan->doors[d].wall_index + 1]++] = d;
    builder->door_starts = starts;
    builder->doors_of_wall = sorted;
}

/* Where a wall's doors that are not locked stand open; NULL: nowhere. */
static GEOSGeometry *openings_of(Builder *builder, size_t w) {
    const Plan *plan = builder->plan;
    double half = plan->walls[w].thickness / 2 + 1e-3;
    GEOSGeometry **holes = NULL;
    size_t count = 0, capacity = 0;
    for (size_t i = builder->door_starts[w]; i < builder->door_starts[w + 1]; i++) {
        const Door *door = &plan->doors[builder->doors_of_wall[i]];
        if (door->state == DOOR_LOCKED)
            continue;
        Vec2 from, to, corners[4];
        plan_door_ends(plan, door, &from, &to);
        strip(from, to, half, half, corners);
        holes = memory_reserve(holes, &capacity, count + 1, sizeof *holes);
        holes[count++] = polygon_of(builder, corners);
    }
    GEOSGeometry *united = NULL;
    if (count) {
        GEOSGeometry *all = GEOSGeom_createCollection_r(builder->geos, GEOS_GEOMETRYCOLLECTION, holes, (unsigned)count);
        united = all ? GEOSUnaryUnion_r(builder->geos, all) : NULL;
        GEOSGeom_destroy_r(builder->geos, all);
        builder->failed |= !united;
    }
    memory_free(holes);
    return united;
}

static GEOSGeometry *cut_doors(Builder *builder, size_t w, GEOSGeometry *wall) {
    GEOSGeometry *openings = wall ? openings_of(builder, w) : NULL;
    if (!openings)
        return wall;
    GEOSGeometry *rest = GEOSDifference_r(builder->geos, wall, openings);
    GEOSGeom_destroy_r(builder->geos, openings);
    GEOSGeom_destroy_r(builder->geos, wall);
    return rest;
}

/* The centre line of a wall, longer where it meets another's end; memory_free it. `solids` are the wall's own. */
static Vec2 *centre_line(Builder *builder, size_t w, Solid *solids) {
    const Wall *wall = &builder->plan->walls[w];
    size_t count = wall->points.count;
    double half = wall->thickness / 2;
    Vec2 *points = memory_allocate(count, sizeof *points);
    memcpy(points, wall->points.at, count * sizeof *points);
    if (is_closed(wall)) {
        points[count - 1] = points[0]; /* to the last bit, or GEOS makes no ring of it */
        return points;
    }
    Vec2 first = vec2_unit(vec2_sub(points[0], points[1]));
    Vec2 last = vec2_unit(vec2_sub(points[count - 1], points[count - 2]));
    if (meets_an_end(builder, w, points[0], first))
        points[0] = vec2_along(points[0], half, first);
    if (meets_an_end(builder, w, points[count - 1], last))
        points[count - 1] = vec2_along(points[count - 1], half, last);
    strip(points[0], points[1], half, half, solids[0].corners);
    strip(points[count - 2], points[count - 1], half, half, solids[count - 2].corners);
    return points;
}

/* The wall's solids are those from `solid` on. */
static void add_wall(Builder *builder, size_t w, size_t solid) {
    const Wall *wall = &builder->plan->walls[w];
    Vec2 *points = centre_line(builder, w, &builder->solids[solid]);
    if (wall->thickness > 0) {
        GEOSGeometry *line = line_of(builder, points, wall->points.count, is_closed(wall));
        GEOSGeometry *body = NULL;
        if (line)
            body = GEOSBufferWithStyle_r(builder->geos, line, wall->thickness / 2, 8, GEOSBUF_CAP_FLAT,
                                         GEOSBUF_JOIN_MITRE, MITRE_LIMIT);
        GEOSGeom_destroy_r(builder->geos, line);
        add_part(builder, cut_doors(builder, w, body));
    }
    memory_free(points);
}

/* The leaf of a hinged door that stands open, at a right angle to its wall. It hangs beside the opening and does not
 * narrow it: `width` is what is clear. */
static void open_leaf(const Plan *plan, const Door *door, double from_wall, Vec2 corners[4]) {
    Vec2 from, to;
    plan_door_ends(plan, door, &from, &to);
    Vec2 along = vec2_unit(vec2_sub(to, from));
    Vec2 out = door->swing == SWING_LEFT ? vec2_left(along) : vec2_scale(vec2_left(along), -1);
    Vec2 hinge = door->hinge == HINGE_START ? from : to;
    double half = plan->walls[door->wall_index].thickness / 2;
    Vec2 root = vec2_along(hinge, from_wall, out), tip = vec2_along(hinge, half + door->width, out);
    bool beside_left = (door->hinge == HINGE_START) == (door->swing == SWING_LEFT);
    strip(root, tip, beside_left ? OUTLINE_LEAF_THICKNESS : 0, beside_left ? 0 : OUTLINE_LEAF_THICKNESS, corners);
}

static void add_standing_solids(Builder *builder) {
    const Plan *plan = builder->plan;
    Vec2 corners[4];
    for (size_t f = 0; f < plan->furniture_count; f++) {
        plan_furniture_corners(&plan->furniture[f], corners);
        add_solid(builder, corners, 0, OWNER_FURNITURE, f);
    }
    for (size_t d = 0; d < plan->door_count; d++) {
        if (plan->doors[d].kind == DOOR_HINGED && plan->doors[d].state == DOOR_OPEN) {
            open_leaf(plan, &plan->doors[d], 0, corners);
            add_solid(builder, corners, 0, OWNER_DOOR, d);
        }
    }
}

typedef struct Meetings {
    const Builder *builder;
    Box box;
    size_t met, looked_at;
} Meetings;

static bool visit_meeting(void *context, int item) {
    Meetings *meetings = context;
    Box box = box_of_corners(meetings->builder->solids[item].corners), own = meetings->box;
    meetings->met +=
        box.low.x <= own.high.x && own.low.x <= box.high.x && box.low.y <= own.high.y && own.low.y <= box.high.y;
    meetings->looked_at++;
    return meetings->met <= MOST_MEETINGS && meetings->looked_at <= MOST_NEAR;
}

/* False, with a message: more solids meet, or nearly, than can be united in bounded time. */
static bool few_meet(Builder *builder) {
    Meetings meetings = {.builder = builder};
    bool few = true;
    for (size_t i = 0; i < builder->solid_count && few; i++) {
        meetings.box = box_of_corners(builder->solids[i].corners);
        broadphase_visit(builder->near_solids, meetings.box, visit_meeting, &meetings);
        few = meetings.met <= MOST_MEETINGS && meetings.looked_at <= MOST_NEAR;
    }
    if (!few)
        snprintf(builder->message, sizeof builder->message,
                 "they and furniture meet in more than %d places, must be fewer", MOST_MEETINGS / 2);
    return few;
}

static GEOSGeometry *unite(Builder *builder) {
    GEOSGeometry *all = GEOSGeom_createCollection_r(builder->geos, GEOS_GEOMETRYCOLLECTION, builder->parts,
                                                    (unsigned)builder->part_count);
    builder->part_count = 0; /* the collection owns them now */
    GEOSGeometry *united = all ? GEOSUnaryUnionPrec_r(builder->geos, all, UNION_GRID) : NULL;
    GEOSGeom_destroy_r(builder->geos, all);
    return united;
}

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

/* How far p is outside a convex quadrangle: at most 0 inside. */
static double outside(const Vec2 corners[4], Vec2 p) {
    double most = -HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        Vec2 edge = vec2_unit(vec2_sub(corners[(i + 1) % 4], corners[i]));
        most = fmax(most, -vec2_cross(edge, vec2_sub(p, corners[i])));
    }
    return most;
}

/* Furniture and leaves come before walls: what leans on a wall is named itself. */
static const Solid *owner_at(Builder *builder, Vec2 middle) {
    size_t found = find_near(builder, box_around(middle, 10 * OWNER_TOLERANCE));
    const Solid *best = NULL;
    double best_outside = HUGE_VAL;
    for (size_t i = 0; i < found; i++) {
        const Solid *solid = &builder->solids[builder->near[i]];
        double distance = fmax(outside(solid->corners, middle), OWNER_TOLERANCE);
        bool better = distance < best_outside ||
                      (distance == best_outside && best->owner == OWNER_WALL && solid->owner != OWNER_WALL);
        if (better) {
            best = solid;
            best_outside = distance;
        }
    }
    return best;
}

/* Drops repeated points and those on a straight line between their neighbours; returns how many are left. */
static size_t straighten(Vec2 *ring, size_t count) {
    bool changed = true;
    while (changed && count > 2) {
        changed = false;
        for (size_t i = 0; i < count && count > 2;) {
            Vec2 before = ring[(i + count - 1) % count], here = ring[i], after = ring[(i + 1) % count];
            Vec2 in = vec2_unit(vec2_sub(here, before)), out = vec2_unit(vec2_sub(after, here));
            bool straight = vec2_dot(in, out) > 0 && fabs(vec2_cross(in, out)) < STRAIGHT;
            if (straight || vec2_distance(before, here) < 2 * UNION_GRID) {
                memmove(ring + i, ring + i + 1, (count - i - 1) * sizeof *ring);
                count--;
                changed = true;
            } else {
                i++;
            }
        }
    }
    return count;
}

/* Adds the faces and convex corners of a closed ring (its first point not repeated), the solid to its left. */
static void add_ring(Builder *builder, const Vec2 *ring, size_t count) {
    size_t first = builder->outline->face_count;
    for (size_t i = 0; i < count; i++) {
        Vec2 a = ring[i], b = ring[(i + 1) % count];
        const Solid *owner = owner_at(builder, vec2_scale(vec2_add(a, b), 0.5));
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
        bool end = fabs(vec2_cross(in, out)) <= STRAIGHT && vec2_dot(in, out) < 0; /* of a thin wall */
        if (vec2_cross(in, out) > STRAIGHT || end)
            add_corner(
                builder,
                (Corner){.at = face->a, .in = in, .out = out, .owner = face->owner, .index = face->index, .door = -1});
    }
}

static void keep_ring(Builder *builder, const Vec2 *ring, size_t count) {
    Outline *outline = builder->outline;
    outline->ring_points = memory_reserve(outline->ring_points, &builder->ring_point_capacity,
                                          outline->ring_point_count + count, sizeof *outline->ring_points);
    memcpy(outline->ring_points + outline->ring_point_count, ring, count * sizeof *ring);
    outline->ring_point_count += count;
    outline->ring_count++;
    outline->ring_starts = memory_reserve(outline->ring_starts, &builder->ring_capacity, outline->ring_count + 1,
                                          sizeof *outline->ring_starts);
    outline->ring_starts[outline->ring_count] = outline->ring_point_count;
}

static void add_geos_ring(Builder *builder, const GEOSGeometry *line, bool hole) {
    const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(builder->geos, line);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(builder->geos, sequence, &size);
    if (size < 4)
        return;
    size_t count = size - 1;
    Vec2 *ring = memory_allocate(count, sizeof *ring);
    double area = 0;
    for (unsigned i = 0; i < count; i++)
        GEOSCoordSeq_getXY_r(builder->geos, sequence, i, &ring[i].x, &ring[i].y);
    for (size_t i = 0; i < count; i++)
        area += vec2_cross(vec2_sub(ring[i], ring[0]), vec2_sub(ring[(i + 1) % count], ring[0]));
    if ((area > 0) == hole)
        for (size_t i = 0; i < count / 2; i++) {
            Vec2 swapped = ring[i];
            ring[i] = ring[count - 1 - i];
            ring[count - 1 - i] = swapped;
        }
    count = straighten(ring, count);
    if (count > 2) {
        add_ring(builder, ring, count);
        keep_ring(builder, ring, count);
    }
    memory_free(ring);
}

static void add_polygons(Builder *builder, const GEOSGeometry *geometry) {
    GEOSContextHandle_t geos = builder->geos;
    if (GEOSGeomTypeId_r(geos, geometry) == GEOS_POLYGON) {
        if (GEOSisEmpty_r(geos, geometry))
            return;
        add_geos_ring(builder, GEOSGetExteriorRing_r(geos, geometry), false);
        for (int i = 0; i < GEOSGetNumInteriorRings_r(geos, geometry); i++)
            add_geos_ring(builder, GEOSGetInteriorRingN_r(geos, geometry, i), true);
        return;
    }
    for (int i = 0; i < GEOSGetNumGeometries_r(geos, geometry); i++)
        if (GEOSGetGeometryN_r(geos, geometry, i) != geometry)
            add_polygons(builder, GEOSGetGeometryN_r(geos, geometry, i));
}

/* A thin wall's lines, there and back. */
static void add_thin_lines(Builder *builder, const GEOSGeometry *geometry) {
    GEOSContextHandle_t geos = builder->geos;
    int type = GEOSGeomTypeId_r(geos, geometry);
    if (type == GEOS_LINESTRING || type == GEOS_LINEARRING) {
        const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(geos, geometry);
        unsigned size = 0;
        GEOSCoordSeq_getSize_r(geos, sequence, &size);
        if (size < 2)
            return;
        size_t count = 2 * (size_t)size - 2;
        Vec2 *ring = memory_allocate(count, sizeof *ring);
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

static void add_thin_walls(Builder *builder, const GEOSGeometry *solids) {
    for (size_t w = 0; w < builder->plan->wall_count; w++) {
        const Wall *wall = &builder->plan->walls[w];
        if (wall->thickness > 0)
            continue;
        GEOSGeometry *line = cut_doors(builder, w, line_of(builder, wall->points.at, wall->points.count, false));
        GEOSGeometry *rest = line ? GEOSDifference_r(builder->geos, line, solids) : NULL;
        if (rest)
            add_thin_lines(builder, rest);
        GEOSGeom_destroy_r(builder->geos, rest);
        GEOSGeom_destroy_r(builder->geos, line);
    }
}

/* The leaf of a door that can be opened, shut (two faces, the ends are in the wall) and open (its root is). */
static void add_moving_leaf(Builder *builder, size_t d) {
    const Plan *plan = builder->plan;
    const Door *door = &plan->doors[d];
    Vec2 from, to, corners[4];
    plan_door_ends(plan, door, &from, &to);
    strip(from, to, OUTLINE_LEAF_THICKNESS / 2, OUTLINE_LEAF_THICKNESS / 2, corners);
    Face face = {.owner = OWNER_DOOR, .index = (int)d, .door = (int)d, .presence = PRESENT_SHUT};
    for (int side = 0; side < 4; side += 2) {
        face.a = corners[side];
        face.b = corners[side + 1];
        add_face(builder, face);
    }
    if (door->kind != DOOR_HINGED)
        return;
    open_leaf(plan, door, plan->walls[door->wall_index].thickness / 2, corners);
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
    sort_doors(builder);
    for (size_t w = 0; w < plan->wall_count; w++)
        add_wall_solids(builder, w);
    size_t of_walls = builder->solid_count;
    add_standing_solids(builder);
    if (!few_meet(builder))
        return false;
    for (size_t w = 0, solid = 0; w < plan->wall_count; solid += plan->walls[w].points.count - 1, w++)
        add_wall(builder, w, solid);
    for (size_t i = of_walls; i < builder->solid_count; i++)
        add_part(builder, polygon_of(builder, builder->solids[i].corners));
    GEOSGeometry *solids = unite(builder);
    if (!solids || builder->failed) {
        GEOSGeom_destroy_r(builder->geos, solids);
        return false;
    }
    add_polygons(builder, solids);
    add_thin_walls(builder, solids);
    GEOSGeom_destroy_r(builder->geos, solids);
    for (size_t d = 0; d < plan->door_count; d++)
        if (outline_door_moves(&plan->doors[d]))
            add_moving_leaf(builder, d);
    return true;
}

bool outline_build(Outline *outline, const Plan *plan, Fault *fault) {
    Outline built = {.ring_starts = NULL};
    Builder builder = {.outline = &built, .plan = plan, .geos = GEOS_init_r(), .near_solids = broadphase_create()};
    GEOSContext_setErrorMessageHandler_r(builder.geos, remember_message, &builder);
    built.ring_starts = memory_reserve(NULL, &builder.ring_capacity, 1, sizeof *built.ring_starts);
    bool good = build(&builder);
    for (size_t i = 0; i < builder.part_count; i++)
        GEOSGeom_destroy_r(builder.geos, builder.parts[i]);
    memory_free(builder.parts);
    memory_free(builder.solids);
    memory_free(builder.near);
    memory_free(builder.door_starts);
    memory_free(builder.doors_of_wall);
    broadphase_destroy(builder.near_solids);
    GEOS_finish_r(builder.geos);
    if (good) {
        built.box = plan_box(plan, &built);
        fill_broadphase(&built);
        outline_free(outline);
        *outline = built;
    } else {
        fault_add(fault, "%s:1:1: the walls cannot be united: %s", plan->path, builder.message);
        outline_free(&built);
    }
    return good;
}

void outline_free(Outline *outline) {
    memory_free(outline->faces);
    memory_free(outline->corners);
    memory_free(outline->ring_points);
    memory_free(outline->ring_starts);
    if (outline->broadphase)
        broadphase_destroy(outline->broadphase);
    *outline = (Outline){0};
}

/* Rays and names ------------------------------------------------------------------------------------------------- */

typedef struct RayContext {
    const Outline *outline;
    int face; /* the one met */
} RayContext;

static double ray_hit(void *context, int item, Vec2 from, Vec2 to, double best) {
    RayContext *ray = context;
    if ((size_t)item >= ray->outline->face_count || !outline_planned(ray->outline->faces[item].presence))
        return best;
    const Face *face = &ray->outline->faces[item];
    Vec2 along = vec2_sub(to, from), side = vec2_sub(face->b, face->a), offset = vec2_sub(face->a, from);
    double turn = vec2_cross(along, side);
    if (fabs(turn) < GRAZING * vec2_length(along) * vec2_length(side)) /* along the face: its neighbours end the ray */
        return best;
    double t = vec2_cross(offset, side) / turn, s = vec2_cross(offset, along) / turn;
    if (t < 0 || t >= best || s < 0 || s > 1)
        return best;
    ray->face = item;
    return t;
}

double outline_ray(const Outline *outline, Vec2 from, Vec2 direction, double reach, int *face) {
    RayContext context = {outline, -1};
    double fraction = broadphase_ray(outline->broadphase, from, vec2_along(from, reach, direction), ray_hit, &context);
    if (face)
        *face = context.face;
    return fraction * reach;
}

void outline_name(const Plan *plan, int owner, int index, char *name, size_t size) {
    switch ((Owner)owner) {
    case OWNER_WALL:
        snprintf(name, size, "wall %s", plan->walls[index].id);
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

void outline_place_name(const Outline *outline, const Plan *plan, Vec2 at, char *name, size_t size) {
    const double beside_door = 0.35; /* m: a body's middle is this near to a door's line while it passes */
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_door_ends(plan, &plan->doors[d], &from, &to);
        if (vec2_distance(at, vec2_nearest_on_segment(at, from, to)) < beside_door) {
            outline_name(plan, OWNER_DOOR, (int)d, name, size);
            return;
        }
    }
    NearestContext nearest = {outline, at, -1, HUGE_VAL};
    for (double reach = 0.5; nearest.face < 0 && reach < 100; reach *= 4)
        broadphase_visit(outline->broadphase, box_around(at, reach), visit_nearest, &nearest);
    if (nearest.face < 0)
        snprintf(name, size, "(%.2f, %.2f)", at.x, at.y);
    else
        outline_name(plan, outline->faces[nearest.face].owner, outline->faces[nearest.face].index, name, size);
}
