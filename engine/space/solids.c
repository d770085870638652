#include "space/solids.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "space/unite.h"

/* m: largest distance of an edge's middle from the solid to which it belongs, a few steps of the grid. */
static const double OWNER_TOLERANCE = 1e-5;
/* 1: sine of the largest angle at which two walls count as one straight wall. */
static const double COLLINEAR = 0.05;
/* 1: length limit of mitred joints of walls, in half thicknesses. */
static const double MITRE_LIMIT = 5;
/* m: ends of walls within this distance meet. */
static const double END_TOLERANCE = 1e-6;
/* m: a wall whose last point is this near to its first is closed. */
static const double CLOSED_TOLERANCE = 1e-9;

enum {
    /* Limits the pairs of wall pieces or furniture whose boxes meet, each pair counted from both sides. Each pair may
       be a crossing, of which a thousand take some 0.1 s and 5 MB to unite; 100,000 walls that meet at their ends give
       as many pairs. */
    MOST_MEETINGS = 400000,
    MOST_NEAR = 100 * MOST_MEETINGS /* candidate pairs examined for that, which take some seconds */
};

static void remember_message(const char *message, void *context) {
    Solids *solids = context;
    snprintf(solids->message, sizeof solids->message, "%s", message);
}

void solids_init(Solids *solids, const Plan *plan) {
    *solids = (Solids){.plan = plan, .geos = GEOS_init_r(), .tree = broadphase_create()};
    GEOSContext_setErrorMessageHandler_r(solids->geos, remember_message, solids);
}

void solids_clear(Solids *solids) {
    for (size_t i = 0; i < solids->part_count; i++)
        GEOSGeom_destroy_r(solids->geos, solids->parts[i]);
    memory_free(solids->parts);
    memory_free(solids->list);
    memory_free(solids->near);
    memory_free(solids->door_starts);
    memory_free(solids->doors_of_wall);
    broadphase_destroy(solids->tree);
    GEOS_finish_r(solids->geos);
    *solids = (Solids){0};
}

static GEOSGeometry *line_of(const Solids *solids, const Vec2 *points, size_t count, bool ring) {
    GEOSCoordSequence *sequence = GEOSCoordSeq_create_r(solids->geos, (unsigned)count, 2);
    for (size_t i = 0; i < count; i++)
        GEOSCoordSeq_setXY_r(solids->geos, sequence, (unsigned)i, points[i].x, points[i].y);
    return ring ? GEOSGeom_createLinearRing_r(solids->geos, sequence)
                : GEOSGeom_createLineString_r(solids->geos, sequence);
}

static GEOSGeometry *polygon_of(const Solids *solids, const Vec2 corners[4]) {
    Vec2 closed[5] = {corners[0], corners[1], corners[2], corners[3], corners[0]};
    return GEOSGeom_createPolygon_r(solids->geos, line_of(solids, closed, 5, true), NULL, 0);
}

static void add_part(Solids *solids, GEOSGeometry *part) {
    if (!part) {
        solids->failed = true; /* a missing wall would open an exit that does not exist */
        return;
    }
    solids->parts =
        memory_reserve(solids->parts, &solids->part_capacity, solids->part_count + 1, sizeof *solids->parts);
    solids->parts[solids->part_count++] = part;
}

static Box box_of_corners(const Vec2 corners[4]) {
    Box box = box_empty();
    for (int i = 0; i < 4; i++)
        box = box_include(box, corners[i]);
    return box;
}

/* Adds a solid. The broad phase's box is larger by `grown` m, for corners that are not known yet. */
static void add_solid(Solids *solids, const Vec2 corners[4], double grown, int owner, size_t index) {
    solids->list = memory_reserve(solids->list, &solids->capacity, solids->count + 1, sizeof *solids->list);
    Solid *solid = &solids->list[solids->count];
    memcpy(solid->corners, corners, sizeof solid->corners);
    solid->owner = owner;
    solid->index = (int)index;
    broadphase_insert(solids->tree, box_expand(box_of_corners(corners), grown), (int)solids->count++);
}

/* Returns the number of solids whose boxes meet the box; solids->near lists them in rising order. */
static size_t find_near(Solids *solids, Box box) {
    size_t found = broadphase_query(solids->tree, box, solids->near, solids->near_capacity);
    if (found > solids->near_capacity) {
        solids->near = memory_reserve(solids->near, &solids->near_capacity, found, sizeof *solids->near);
        broadphase_query(solids->tree, box, solids->near, found);
    }
    return found;
}

void solids_strip(Vec2 a, Vec2 b, double left, double right, Vec2 corners[4]) {
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

/* Adds the pieces of the wall between its points, as wide as the wall is thick. */
static void add_wall_solids(Solids *solids, size_t w) {
    const Wall *wall = &solids->plan->walls[w];
    double half = wall->thickness / 2;
    for (size_t s = 0; s + 1 < wall->points.count; s++) {
        Vec2 corners[4];
        solids_strip(wall->points.at[s], wall->points.at[s + 1], half, half, corners);
        add_solid(solids, corners, half, OWNER_WALL, w); /* its ends may extend by half the thickness */
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

/* True if another wall ends at this wall's end, at an angle to `along`, its direction there. Both then extend by half
 * their thickness and close the corner; walls that continue straight need not, and a door may begin there. */
static bool meets_an_end(Solids *solids, size_t wall, Vec2 end, Vec2 along) {
    size_t found = find_near(solids, box_around(end, END_TOLERANCE));
    for (size_t i = 0; i < found; i++) {
        const Solid *solid = &solids->list[solids->near[i]];
        if (solid->owner == OWNER_WALL && (size_t)solid->index != wall &&
            ends_at_an_angle(&solids->plan->walls[solid->index], end, along))
            return true;
    }
    return false;
}

static void sort_doors(Solids *solids) {
    const Plan *plan = solids->plan;
    size_t *starts = memory_zeroed(plan->wall_count + 2, sizeof *starts);
    size_t *sorted = memory_zeroed(plan->door_count, sizeof *sorted);
    for (size_t d = 0; d < plan->door_count; d++)
        starts[plan->doors[d].wall_index + 2]++;
    for (size_t w = 2; w < plan->wall_count + 2; w++)
        starts[w] += starts[w - 1];
    for (size_t d = 0; d < plan->door_count;
         d++) /* which turns the start of the next wall into the start of this one */
        sorted[starts[plan->doors[d].wall_index + 1]++] = d;
    solids->door_starts = starts;
    solids->doors_of_wall = sorted;
}

/* Returns the openings of a wall's doors that are not locked; NULL: none. */
static GEOSGeometry *openings_of(Solids *solids, size_t w) {
    const Plan *plan = solids->plan;
    double half = plan->walls[w].thickness / 2 + 1e-3;
    GEOSGeometry **holes = NULL;
    size_t count = 0, capacity = 0;
    for (size_t i = solids->door_starts[w]; i < solids->door_starts[w + 1]; i++) {
        const Door *door = &plan->doors[solids->doors_of_wall[i]];
        if (door->state == DOOR_LOCKED)
            continue;
        Vec2 from, to, corners[4];
        plan_geometry_door_ends(plan, door, &from, &to);
        solids_strip(from, to, half, half, corners);
        holes = memory_reserve(holes, &capacity, count + 1, sizeof *holes);
        holes[count++] = polygon_of(solids, corners);
    }
    GEOSGeometry *united = NULL;
    if (count) {
        GEOSGeometry *all = GEOSGeom_createCollection_r(solids->geos, GEOS_GEOMETRYCOLLECTION, holes, (unsigned)count);
        united = all ? GEOSUnaryUnion_r(solids->geos, all) : NULL;
        GEOSGeom_destroy_r(solids->geos, all);
        solids->failed |= !united;
    }
    memory_free(holes);
    return united;
}

static GEOSGeometry *cut_doors(Solids *solids, size_t w, GEOSGeometry *wall) {
    GEOSGeometry *openings = wall ? openings_of(solids, w) : NULL;
    if (!openings)
        return wall;
    GEOSGeometry *rest = GEOSDifference_r(solids->geos, wall, openings);
    GEOSGeom_destroy_r(solids->geos, openings);
    GEOSGeom_destroy_r(solids->geos, wall);
    return rest;
}

/* Returns the centre line of a wall, extended where the wall meets another's end; memory_free it. `own` are its solids.
 */
static Vec2 *centre_line(Solids *solids, size_t w, Solid *own) {
    const Wall *wall = &solids->plan->walls[w];
    size_t count = wall->points.count;
    double half = wall->thickness / 2;
    Vec2 *points = memory_zeroed(count, sizeof *points);
    memcpy(points, wall->points.at, count * sizeof *points);
    if (is_closed(wall)) {
        points[count - 1] = points[0]; /* equal to the last bit, or GEOS makes no ring */
        return points;
    }
    Vec2 first = vec2_unit(vec2_sub(points[0], points[1]));
    Vec2 last = vec2_unit(vec2_sub(points[count - 1], points[count - 2]));
    if (meets_an_end(solids, w, points[0], first))
        points[0] = vec2_along(points[0], half, first);
    if (meets_an_end(solids, w, points[count - 1], last))
        points[count - 1] = vec2_along(points[count - 1], half, last);
    solids_strip(points[0], points[1], half, half, own[0].corners);
    solids_strip(points[count - 2], points[count - 1], half, half, own[count - 2].corners);
    return points;
}

/* Adds a wall, whose solids are those from `solid` on. */
static void add_wall(Solids *solids, size_t w, size_t solid) {
    const Wall *wall = &solids->plan->walls[w];
    Vec2 *points = centre_line(solids, w, &solids->list[solid]);
    if (wall->thickness > 0) {
        GEOSGeometry *line = line_of(solids, points, wall->points.count, is_closed(wall));
        GEOSGeometry *body = NULL;
        if (line)
            body = GEOSBufferWithStyle_r(solids->geos, line, wall->thickness / 2, 8, GEOSBUF_CAP_FLAT,
                                         GEOSBUF_JOIN_MITRE, MITRE_LIMIT);
        GEOSGeom_destroy_r(solids->geos, line);
        add_part(solids, cut_doors(solids, w, body));
    }
    memory_free(points);
}

void solids_open_leaf(const Plan *plan, const Door *door, double from_wall, Vec2 corners[4]) {
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    Vec2 along = vec2_unit(vec2_sub(to, from));
    Vec2 out = door->swing == SWING_LEFT ? vec2_left(along) : vec2_scale(vec2_left(along), -1);
    Vec2 hinge = door->hinge == HINGE_START ? from : to;
    double half = plan->walls[door->wall_index].thickness / 2;
    Vec2 root = vec2_along(hinge, from_wall, out), tip = vec2_along(hinge, half + door->width, out);
    bool beside_left = (door->hinge == HINGE_START) == (door->swing == SWING_LEFT);
    solids_strip(root, tip, beside_left ? door->leaf : 0, beside_left ? 0 : door->leaf, corners);
}

void solids_rest(const Plan *plan, const Door *door, Vec2 corners[4]) {
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    Vec2 along = vec2_unit(vec2_sub(to, from));
    bool at_start = door->hinge == HINGE_START;
    Vec2 root = at_start ? from : to, tip = vec2_along(root, door->rest, at_start ? along : vec2_scale(along, -1));
    solids_strip(root, tip, door->leaf / 2, door->leaf / 2, corners);
}

static void add_standing_solids(Solids *solids) {
    const Plan *plan = solids->plan;
    Vec2 corners[4];
    for (size_t f = 0; f < plan->furniture_count; f++) {
        plan_geometry_corners(&plan->furniture[f], corners);
        add_solid(solids, corners, 0, OWNER_FURNITURE, f);
    }
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        bool rests = door->kind == DOOR_SLIDING && door->rest > 0;
        if (door->state != DOOR_OPEN || !(door->leaf > 0) || (door->kind != DOOR_HINGED && !rests))
            continue;
        if (rests)
            solids_rest(plan, door, corners);
        else
            solids_open_leaf(plan, door, 0, corners);
        add_solid(solids, corners, 0, OWNER_DOOR, d);
    }
}

typedef struct Meetings {
    const Solids *solids;
    Box box;
    size_t met, looked_at;
} Meetings;

static bool visit_meeting(void *context, int item) {
    Meetings *meetings = context;
    Box box = box_of_corners(meetings->solids->list[item].corners), own = meetings->box;
    meetings->met +=
        box.low.x <= own.high.x && own.low.x <= box.high.x && box.low.y <= own.high.y && own.low.y <= box.high.y;
    meetings->looked_at++;
    return meetings->met <= MOST_MEETINGS && meetings->looked_at <= MOST_NEAR;
}

/* Returns false, with a message, if more solids meet, or nearly meet, than can be united in bounded time. */
static bool few_meet(Solids *solids) {
    Meetings meetings = {.solids = solids};
    bool few = true;
    for (size_t i = 0; i < solids->count && few; i++) {
        meetings.box = box_of_corners(solids->list[i].corners);
        broadphase_visit(solids->tree, meetings.box, visit_meeting, &meetings);
        few = meetings.met <= MOST_MEETINGS && meetings.looked_at <= MOST_NEAR;
    }
    if (!few)
        snprintf(solids->message, sizeof solids->message,
                 "they and furniture meet in more than %d places, must be fewer", MOST_MEETINGS / 2);
    return few;
}

/* Returns NULL, with a message, if GEOS could not make or unite one of the parts. */
static GEOSGeometry *unite_parts(Solids *solids) {
    GEOSGeometry *all =
        GEOSGeom_createCollection_r(solids->geos, GEOS_GEOMETRYCOLLECTION, solids->parts, (unsigned)solids->part_count);
    solids->part_count = 0; /* the collection owns them now */
    GEOSGeometry *united = all ? unite_polygons(solids->geos, all, SOLIDS_GRID) : NULL;
    GEOSGeom_destroy_r(solids->geos, all);
    if (united && !solids->failed)
        return united;
    GEOSGeom_destroy_r(solids->geos, united);
    return NULL;
}

static void add_all_walls_solids(Solids *solids) {
    sort_doors(solids);
    for (size_t w = 0; w < solids->plan->wall_count; w++)
        add_wall_solids(solids, w);
}

static void add_walls(Solids *solids, double low, double high) {
    const Plan *plan = solids->plan;
    for (size_t w = 0, solid = 0; w < plan->wall_count; solid += plan->walls[w].points.count - 1, w++)
        if (plan->walls[w].height >= low && plan->walls[w].height < high)
            add_wall(solids, w, solid);
}

GEOSGeometry *solids_unite(Solids *solids) {
    add_all_walls_solids(solids);
    size_t of_walls = solids->count;
    add_standing_solids(solids);
    if (!few_meet(solids))
        return NULL;
    add_walls(solids, 0, HUGE_VAL);
    for (size_t i = of_walls; i < solids->count; i++)
        add_part(solids, polygon_of(solids, solids->list[i].corners));
    return unite_parts(solids);
}

GEOSGeometry *solids_unite_walls(Solids *solids, double low, double high) {
    add_all_walls_solids(solids);
    if (!few_meet(solids))
        return NULL;
    add_walls(solids, low, high);
    return unite_parts(solids);
}

/* Drops repeated points and those on a straight line between their neighbours; returns the number of points left. */
static size_t straighten(Vec2 *ring, size_t count) {
    bool changed = true;
    while (changed && count > 2) {
        changed = false;
        for (size_t i = 0; i < count && count > 2;) {
            Vec2 before = ring[(i + count - 1) % count], here = ring[i], after = ring[(i + 1) % count];
            Vec2 in = vec2_unit(vec2_sub(here, before)), out = vec2_unit(vec2_sub(after, here));
            bool straight = vec2_dot(in, out) > 0 && fabs(vec2_cross(in, out)) < SOLIDS_STRAIGHT;
            if (straight || vec2_distance(before, here) < 2 * SOLIDS_GRID) {
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

static void add_ring(Rings *rings, const Vec2 *ring, size_t count) {
    rings->points =
        memory_reserve(rings->points, &rings->point_capacity, rings->point_count + count, sizeof *rings->points);
    memcpy(rings->points + rings->point_count, ring, count * sizeof *ring);
    rings->point_count += count;
    rings->count++;
    rings->starts = memory_reserve(rings->starts, &rings->start_capacity, rings->count + 1, sizeof *rings->starts);
    rings->starts[0] = 0;
    rings->starts[rings->count] = rings->point_count;
}

static void add_geos_ring(const Solids *solids, const GEOSGeometry *line, bool hole, Rings *rings) {
    const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(solids->geos, line);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(solids->geos, sequence, &size);
    if (size < 4)
        return;
    size_t count = size - 1;
    Vec2 *ring = memory_zeroed(count, sizeof *ring);
    double area = 0;
    for (unsigned i = 0; i < count; i++)
        GEOSCoordSeq_getXY_r(solids->geos, sequence, i, &ring[i].x, &ring[i].y);
    for (size_t i = 0; i < count; i++)
        area += vec2_cross(vec2_sub(ring[i], ring[0]), vec2_sub(ring[(i + 1) % count], ring[0]));
    if ((area > 0) == hole)
        for (size_t i = 0; i < count / 2; i++) {
            Vec2 swapped = ring[i];
            ring[i] = ring[count - 1 - i];
            ring[count - 1 - i] = swapped;
        }
    count = straighten(ring, count);
    if (count > 2)
        add_ring(rings, ring, count);
    memory_free(ring);
}

void solids_add_rings(const Solids *solids, const GEOSGeometry *geometry, Rings *rings) {
    GEOSContextHandle_t geos = solids->geos;
    if (GEOSGeomTypeId_r(geos, geometry) == GEOS_POLYGON) {
        if (GEOSisEmpty_r(geos, geometry))
            return;
        add_geos_ring(solids, GEOSGetExteriorRing_r(geos, geometry), false, rings);
        for (int i = 0; i < GEOSGetNumInteriorRings_r(geos, geometry); i++)
            add_geos_ring(solids, GEOSGetInteriorRingN_r(geos, geometry, i), true, rings);
        return;
    }
    for (int i = 0; i < GEOSGetNumGeometries_r(geos, geometry); i++)
        if (GEOSGetGeometryN_r(geos, geometry, i) != geometry)
            solids_add_rings(solids, GEOSGetGeometryN_r(geos, geometry, i), rings);
}

GEOSGeometry *solids_thin_wall(Solids *solids, size_t w, const GEOSGeometry *united) {
    const Points *points = &solids->plan->walls[w].points;
    GEOSGeometry *line = cut_doors(solids, w, line_of(solids, points->at, points->count, false));
    GEOSGeometry *rest = line ? GEOSDifference_r(solids->geos, line, united) : NULL;
    GEOSGeom_destroy_r(solids->geos, line);
    return rest;
}

/* Returns how far p is outside a convex quadrangle: at most 0 inside. */
static double outside(const Vec2 corners[4], Vec2 p) {
    double most = -HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        Vec2 edge = vec2_unit(vec2_sub(corners[(i + 1) % 4], corners[i]));
        most = fmax(most, -vec2_cross(edge, vec2_sub(p, corners[i])));
    }
    return most;
}

const Solid *solids_owner(Solids *solids, Vec2 middle) {
    size_t found = find_near(solids, box_around(middle, 10 * OWNER_TOLERANCE));
    const Solid *best = NULL;
    double best_outside = HUGE_VAL;
    for (size_t i = 0; i < found; i++) {
        const Solid *solid = &solids->list[solids->near[i]];
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
