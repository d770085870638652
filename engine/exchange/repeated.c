#include "exchange/repeated.h"

#include <math.h>

#include "space/solids.h"

static const double SAME = 1e-3; /* m, or degree */
static const double MOST_OVERLAP =
    0.05;                              /* 1: share of the rooms' area; rooms may be drawn to the walls' centre lines */
static const double MOST_WALLS = 0.25; /* 1: share of the rooms' area that walls cover */

enum { MOST_ROOMS = 500, MOST_POINTS = 5000 /* in rooms, and in walls */ };

/* Repeated elements ----------------------------------------------------------------------------------------------- */

static bool same_point(Vec2 a, Vec2 b) {
    return fabs(a.x - b.x) < SAME && fabs(a.y - b.y) < SAME;
}

static bool same_piece(const Furniture *a, const Furniture *b) {
    return same_point(a->centre, b->centre) && same_point(a->size, b->size) &&
           fabs(remainder(a->angle - b->angle, 360)) < SAME && fabs(a->height - b->height) < SAME;
}

static bool same_room(const Room *a, const Room *b) {
    bool same = a->outline.count == b->outline.count;
    for (size_t i = 0; i < a->outline.count && same; i++)
        same = same_point(a->outline.at[i], b->outline.at[i]);
    return same;
}

void repeated_drop(HouseBuilder *builder) {
    Plan *plan = &builder->plan;
    size_t pieces = 0, rooms = 0;
    for (size_t f = 0; f < plan->furniture_count; f++) {
        bool repeats = false;
        for (size_t g = 0; g < pieces && !repeats; g++)
            repeats = same_piece(&plan->furniture[g], &plan->furniture[f]);
        if (!repeats)
            plan->furniture[pieces++] = plan->furniture[f];
    }
    for (size_t r = 0; r < plan->room_count; r++) {
        bool repeats = false;
        for (size_t q = 0; q < rooms && !repeats; q++)
            repeats = same_room(&plan->rooms[q], &plan->rooms[r]);
        if (!repeats)
            plan->rooms[rooms++] = plan->rooms[r];
    }
    if (pieces < plan->furniture_count)
        import_report_note(builder->report, "furniture that stands more than once in the same place counts once (%zu)",
                           plan->furniture_count - pieces);
    if (rooms < plan->room_count)
        import_report_note(builder->report, "rooms with the same outline count once (%zu)", plan->room_count - rooms);
    plan->furniture_count = pieces;
    plan->room_count = rooms;
}

/* Areas ----------------------------------------------------------------------------------------------------------- */

/* Returns the room's area, made valid; NULL if there is none. */
static GEOSGeometry *shape_of(GEOSContextHandle_t geos, const Room *room) {
    size_t count = room->outline.count;
    GEOSCoordSequence *sequence = GEOSCoordSeq_create_r(geos, (unsigned)count + 1, 2);
    for (size_t i = 0; i <= count; i++)
        GEOSCoordSeq_setXY_r(geos, sequence, (unsigned)i, room->outline.at[i % count].x, room->outline.at[i % count].y);
    GEOSGeometry *ring = GEOSGeom_createLinearRing_r(geos, sequence);
    GEOSGeometry *polygon = ring ? GEOSGeom_createPolygon_r(geos, ring, NULL, 0) : NULL;
    GEOSGeometry *valid = polygon ? GEOSMakeValid_r(geos, polygon) : NULL;
    GEOSGeom_destroy_r(geos, polygon);
    return valid;
}

static double area_of(GEOSContextHandle_t geos, const GEOSGeometry *geometry) {
    double area = 0;
    if (geometry)
        GEOSArea_r(geos, geometry, &area);
    return area;
}

/* Unites the rooms; `*sum` is the sum of their areas. */
static GEOSGeometry *unite_rooms(GEOSContextHandle_t geos, const Plan *plan, double *sum) {
    GEOSGeometry *list[MOST_ROOMS];
    unsigned count = 0;
    *sum = 0;
    for (size_t r = 0; r < plan->room_count; r++) {
        GEOSGeometry *shape = shape_of(geos, &plan->rooms[r]);
        *sum += area_of(geos, shape);
        if (shape)
            list[count++] = shape;
    }
    GEOSGeometry *all = GEOSGeom_createCollection_r(geos, GEOS_GEOMETRYCOLLECTION, list, count);
    GEOSGeometry *united = all ? GEOSUnaryUnion_r(geos, all) : NULL;
    GEOSGeom_destroy_r(geos, all);
    return united;
}

static bool is_small(const Plan *plan) {
    size_t walls = 0, rooms = 0;
    for (size_t w = 0; w < plan->wall_count; w++)
        walls += plan->walls[w].points.count;
    for (size_t r = 0; r < plan->room_count; r++)
        rooms += plan->rooms[r].outline.count;
    return plan->room_count <= MOST_ROOMS && walls <= MOST_POINTS && rooms <= MOST_POINTS;
}

void repeated_compare_rooms(const Plan *plan, ImportReport *report) {
    if (!plan->room_count || !is_small(plan))
        return;
    Solids solids;
    solids_init(&solids, plan);
    double sum;
    GEOSGeometry *rooms = unite_rooms(solids.geos, plan, &sum);
    GEOSGeometry *walls = rooms ? solids_unite_walls(&solids, 0, HUGE_VAL) : NULL;
    GEOSGeometry *both = walls ? GEOSIntersection_r(solids.geos, rooms, walls) : NULL;
    double area = area_of(solids.geos, rooms), covered = area_of(solids.geos, both);
    if (area > 0 && sum > (1 + MOST_OVERLAP) * area)
        import_report_note(
            report,
            "the rooms overlap: they have %.4g m2 together and cover %.4g m2; the file may hold its plan "
            "more than once",
            sum, area);
    if (area > 0 && covered > MOST_WALLS * area)
        import_report_note(report,
                           "walls cover %.4g m2 of the rooms' %.4g m2; the file may hold copies of its walls next to "
                           "each other",
                           covered, area);
    GEOSGeom_destroy_r(solids.geos, both);
    GEOSGeom_destroy_r(solids.geos, walls);
    GEOSGeom_destroy_r(solids.geos, rooms);
    solids_clear(&solids);
}
