/* The union of polygons beside that of GEOS alone: the same rings, to the bit. */

#include <string.h>

#include "base/random.h"
#include "base/vec2.h"
#include "check.h"
#include "space/unite.h"

#define GRID 1e-6 /* m */

enum { MOST = 48, SCENES = 150 };

static GEOSGeometry *ring_of(GEOSContextHandle_t geos, const Vec2 *points, unsigned count, bool backwards) {
    GEOSCoordSequence *sequence = GEOSCoordSeq_create_r(geos, count + 1, 2);
    for (unsigned i = 0; i <= count; i++) {
        Vec2 at = points[(backwards ? count - i : i) % count];
        GEOSCoordSeq_setXY_r(geos, sequence, i, at.x, at.y);
    }
    return GEOSGeom_createLinearRing_r(geos, sequence);
}

/* Draws a rectangle or an L at any angle, its corners on a grid of `parts` per metre; some have a hole. */
static GEOSGeometry *draw_polygon(GEOSContextHandle_t geos, Random *random, double span, double parts, bool upright) {
    double width = 0.1 + random_uniform(random), height = 0.1 + 2 * random_uniform(random);
    double angle = upright ? 0 : 2 * M_PI * random_uniform(random);
    Vec2 corner = vec2(span * (random_uniform(random) - 0.3), span * (random_uniform(random) - 0.3));
    bool bent = random_uniform(random) < 0.2, backwards = random_uniform(random) < 0.2;
    const double shape[6][2] = {{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}};
    const int straight[4] = {0, 1, 2, 5};
    Vec2 points[6], hole[4];
    unsigned count = bent ? 6 : 4;
    for (unsigned i = 0; i < count; i++) {
        const double *at = shape[bent ? (int)i : straight[i]];
        double up = !bent && i == 2 ? 1 : at[1];
        Vec2 place = vec2_add(corner, vec2_turn(vec2(width * at[0], height * up), vec2_heading(angle)));
        points[i] = vec2(round(place.x * parts) / parts, round(place.y * parts) / parts);
    }
    bool hollow = !bent && width > 0.5 && height > 0.5 && random_uniform(random) < 0.5;
    for (unsigned i = 0; i < 4; i++)
        hole[i] = vec2_add(vec2_scale(points[i], 0.6), vec2_scale(points[(i + 2) % 4], 0.4));
    GEOSGeometry *inner = hollow ? ring_of(geos, hole, 4, backwards) : NULL;
    return GEOSGeom_createPolygon_r(geos, ring_of(geos, points, count, backwards), inner ? &inner : NULL,
                                    inner != NULL);
}

static bool same_points(GEOSContextHandle_t geos, const GEOSGeometry *a, const GEOSGeometry *b) {
    const GEOSCoordSequence *one = GEOSGeom_getCoordSeq_r(geos, a), *other = GEOSGeom_getCoordSeq_r(geos, b);
    unsigned size = 0, other_size = 0;
    GEOSCoordSeq_getSize_r(geos, one, &size);
    GEOSCoordSeq_getSize_r(geos, other, &other_size);
    for (unsigned i = 0; i < size && size == other_size; i++) {
        Vec2 p, q;
        GEOSCoordSeq_getXY_r(geos, one, i, &p.x, &p.y);
        GEOSCoordSeq_getXY_r(geos, other, i, &q.x, &q.y);
        if (memcmp(&p, &q, sizeof p) != 0)
            return false;
    }
    return size == other_size;
}

static bool same_rings(GEOSContextHandle_t geos, const GEOSGeometry *a, const GEOSGeometry *b) {
    int count = GEOSGetNumGeometries_r(geos, a);
    bool same = count == GEOSGetNumGeometries_r(geos, b);
    for (int i = 0; i < count && same; i++) {
        const GEOSGeometry *one = GEOSGetGeometryN_r(geos, a, i), *other = GEOSGetGeometryN_r(geos, b, i);
        int holes = GEOSGetNumInteriorRings_r(geos, one);
        same = holes == GEOSGetNumInteriorRings_r(geos, other) &&
               same_points(geos, GEOSGetExteriorRing_r(geos, one), GEOSGetExteriorRing_r(geos, other));
        for (int h = 0; h < holes && same; h++)
            same = same_points(geos, GEOSGetInteriorRingN_r(geos, one, h), GEOSGetInteriorRingN_r(geos, other, h));
    }
    return same;
}

/* Scenes of few and many polygons, near and far from each other, on grids on which many touch, and on one that puts
 * some coordinates half-way between two points of the union's. */
TEST(polygons_are_united_as_by_geos_alone) {
    GEOSContextHandle_t geos = GEOS_init_r();
    Random random = random_seed(17, 0);
    int differ = 0, several = 0;
    for (int scene = 0; scene < SCENES; scene++) {
        GEOSGeometry *parts[MOST];
        unsigned count = 2 + (unsigned)((MOST - 2) * random_uniform(&random));
        double span = 1 + 12 * random_uniform(&random);
        double grids[] = {10, 1e7, 1e9};
        for (unsigned i = 0; i < count; i++)
            parts[i] = draw_polygon(geos, &random, span, grids[scene % 3], scene % 3 == 0 || i % 3 != 0);
        GEOSGeometry *all = GEOSGeom_createCollection_r(geos, GEOS_GEOMETRYCOLLECTION, parts, count);
        GEOSGeometry *ours = unite_polygons(geos, all, GRID), *theirs = GEOSUnaryUnionPrec_r(geos, all, GRID);
        if (ours && theirs) {
            differ += !same_rings(geos, ours, theirs);
            several += GEOSGetNumGeometries_r(geos, ours) > 3;
        } else {
            differ += ours || theirs;
        }
        GEOSGeom_destroy_r(geos, ours);
        GEOSGeom_destroy_r(geos, theirs);
        GEOSGeom_destroy_r(geos, all);
    }
    GEOS_finish_r(geos);
    CHECK(differ == 0);
    CHECK(several > SCENES / 2);
}

/* A sliver that vanishes on the grid, a corner given twice, a spike and a bow tie, each beside a square far away. */
TEST(quadrangles_that_are_none_are_left_to_geos) {
    const Vec2 square[4] = {{9, 0}, {10, 0}, {10, 1}, {9, 1}};
    const Vec2 shapes[][4] = {{{0, 0}, {1, 0}, {1, 4e-7}, {0, 4e-7}},
                              {{0, 0}, {1, 0}, {1, 0}, {0, 1}},
                              {{0, 0}, {2, 0}, {1, 0}, {0, 1}},
                              {{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
    GEOSContextHandle_t geos = GEOS_init_r();
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        GEOSGeometry *parts[] = {GEOSGeom_createPolygon_r(geos, ring_of(geos, shapes[s], 4, false), NULL, 0),
                                 GEOSGeom_createPolygon_r(geos, ring_of(geos, square, 4, false), NULL, 0)};
        GEOSGeometry *all = GEOSGeom_createCollection_r(geos, GEOS_GEOMETRYCOLLECTION, parts, 2);
        GEOSGeometry *ours = unite_polygons(geos, all, GRID), *theirs = GEOSUnaryUnionPrec_r(geos, all, GRID);
        CHECK(ours && theirs ? same_rings(geos, ours, theirs) : !ours && !theirs);
        GEOSGeom_destroy_r(geos, ours);
        GEOSGeom_destroy_r(geos, theirs);
        GEOSGeom_destroy_r(geos, all);
    }
    GEOS_finish_r(geos);
}

TEST(nothing_one_polygon_and_a_line_are_left_to_geos) {
    GEOSContextHandle_t geos = GEOS_init_r();
    const Vec2 square[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    GEOSGeometry *none = GEOSGeom_createEmptyCollection_r(geos, GEOS_GEOMETRYCOLLECTION), *empty, *one, *line;
    empty = unite_polygons(geos, none, GRID);
    CHECK(empty && GEOSisEmpty_r(geos, empty));
    GEOSGeometry *polygon = GEOSGeom_createPolygon_r(geos, ring_of(geos, square, 4, false), NULL, 0);
    one = unite_polygons(geos, polygon, GRID);
    CHECK(one && GEOSGeomTypeId_r(geos, one) == GEOS_POLYGON);
    GEOSGeometry *ring = ring_of(geos, square, 4, false);
    line = unite_polygons(geos, ring, GRID);
    CHECK(line && GEOSGeomTypeId_r(geos, line) != GEOS_POLYGON);
    GEOSGeometry *const all[] = {none, empty, polygon, one, ring, line};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        GEOSGeom_destroy_r(geos, all[i]);
    GEOS_finish_r(geos);
}
