#include "paint/tessellation.h"

#include <geos_c.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

static void release(Tessellated *kept) {
    memory_free(kept->points);
    memory_free(kept->starts);
    memory_free(kept->triangles);
    *kept = (Tessellated){0};
}

void tessellation_clear(Tessellation *tessellation) {
    for (size_t i = 0; i < TESSELLATION_KEPT; i++)
        release(&tessellation->kept[i]);
    memory_free(tessellation->triangles);
    memory_free(tessellation->sorted);
    if (tessellation->geos)
        GEOS_finish_r(tessellation->geos);
    *tessellation = (Tessellation){0};
}

static void add_triangle(Tessellation *tessellation, Vec2 a, Vec2 b, Vec2 c, bool border) {
    tessellation->triangles = memory_reserve(tessellation->triangles, &tessellation->capacity, tessellation->count + 1,
                                             sizeof *tessellation->triangles);
    Triangle *triangle = &tessellation->triangles[tessellation->count++];
    bool clockwise = vec2_cross(vec2_sub(b, a), vec2_sub(c, a)) < 0;
    *triangle = (Triangle){{a, clockwise ? c : b, clockwise ? b : c}, {border, border, border}};
}

/* Fans --------------------------------------------------------------------------------------------------------------*/

static Vec2 middle_of(const Vec2 *points, size_t count) {
    Vec2 middle = {0, 0};
    for (size_t i = 0; i < count; i++)
        middle = vec2_along(middle, 1.0 / (double)count, points[i]);
    return middle;
}

/* True if the whole ring is seen from the middle: it goes to one side all the way, and once round. */
static bool is_seen_from(Vec2 middle, const Vec2 *points, size_t count) {
    int left = 0, right = 0, halves = 0;
    for (size_t i = 0; i < count; i++) {
        Vec2 a = vec2_sub(points[i], middle), b = vec2_sub(points[(i + 1) % count], middle);
        double cross = vec2_cross(a, b);
        left += cross > 0;
        right += cross < 0;
        halves += (a.y < 0) != (b.y < 0);
    }
    return !(left && right) && halves <= 2;
}

/* Makes a fan: each triangle has one edge of the outline. */
static void add_fan(Tessellation *tessellation, Vec2 middle, const Vec2 *points, size_t count) {
    for (size_t i = 0; i < count; i++) {
        add_triangle(tessellation, points[i], points[(i + 1) % count], middle, false);
        Triangle *triangle = &tessellation->triangles[tessellation->count - 1];
        /* clockwise ones run from the next point to the middle */
        bool turned = triangle->corners[1].x == middle.x && triangle->corners[1].y == middle.y;
        triangle->border[turned ? 2 : 0] = true;
    }
}

/* Makes two triangles of four points, if both turn the same way. */
static bool add_halves(Tessellation *tessellation, const Vec2 *points) {
    Vec2 diagonal = vec2_sub(points[2], points[0]);
    double right = vec2_cross(vec2_sub(points[1], points[0]), diagonal);
    double left = vec2_cross(diagonal, vec2_sub(points[3], points[0]));
    if (right * left <= 0)
        return false;
    for (size_t half = 0; half < 2; half++) {
        add_triangle(tessellation, points[1 + half], points[2 + half], points[0], true);
        bool turned = right < 0; /* clockwise ones are turned round */
        tessellation->triangles[tessellation->count - 1].border[half == 0 ? 1 : turned ? 0 : 2] = false;
    }
    return true;
}

/* GEOS --------------------------------------------------------------------------------------------------------------*/

static GEOSGeometry *ring_area(GEOSContextHandle_t geos, const Vec2 *points, size_t count) {
    GEOSCoordSequence *sequence = GEOSCoordSeq_create_r(geos, (unsigned)count + 1, 2);
    for (size_t i = 0; i <= count; i++)
        GEOSCoordSeq_setXY_r(geos, sequence, (unsigned)i, points[i % count].x, points[i % count].y);
    GEOSGeometry *ring = GEOSGeom_createPolygon_r(geos, GEOSGeom_createLinearRing_r(geos, sequence), NULL, 0);
    if (!ring || GEOSisValid_r(geos, ring) == 1)
        return ring;
    GEOSGeometry *sound = GEOSMakeValid_r(geos, ring); /* a ring that crosses itself: even-odd */
    GEOSGeom_destroy_r(geos, ring);
    return sound;
}

/* Unites the areas, freeing each: pairs, then pairs of pairs, so that areas of similar size are combined. */
static GEOSGeometry *combined(GEOSContextHandle_t geos, GEOSGeometry **areas, size_t count, bool united) {
    if (count < 2)
        return count ? areas[0] : NULL;
    if (united) {
        GEOSGeometry *all = GEOSGeom_createCollection_r(geos, GEOS_GEOMETRYCOLLECTION, areas, (unsigned)count);
        GEOSGeometry *whole = GEOSUnaryUnion_r(geos, all);
        GEOSGeom_destroy_r(geos, all);
        return whole;
    }
    GEOSGeometry *first = combined(geos, areas, count / 2, false);
    GEOSGeometry *second = combined(geos, areas + count / 2, count - count / 2, false);
    GEOSGeometry *both = first && second ? GEOSSymDifference_r(geos, first, second) : NULL;
    GEOSGeom_destroy_r(geos, first);
    GEOSGeom_destroy_r(geos, second);
    return both;
}

static void add_geometry(Tessellation *tessellation, const GEOSGeometry *geometry) {
    GEOSContextHandle_t geos = tessellation->geos;
    int parts = GEOSGetNumGeometries_r(geos, geometry);
    for (int i = 0; i < parts; i++) {
        const GEOSGeometry *ring = GEOSGetExteriorRing_r(geos, GEOSGetGeometryN_r(geos, geometry, i));
        const GEOSCoordSequence *sequence = ring ? GEOSGeom_getCoordSeq_r(geos, ring) : NULL;
        Vec2 corners[3];
        for (unsigned k = 0; k < 3 && sequence; k++)
            GEOSCoordSeq_getXY_r(geos, sequence, k, &corners[k].x, &corners[k].y);
        if (sequence)
            add_triangle(tessellation, corners[0], corners[1], corners[2], true);
    }
}

/* Borders: the edges that only one triangle has ---------------------------------------------------------------------*/

typedef struct Edge {
    Vec2 low, high; /* ends in the order of their coordinates */
    size_t triangle;
    int side;
} Edge;

static int compare_ends(Vec2 a, Vec2 b) {
    int x = (a.x > b.x) - (a.x < b.x);
    return x ? x : (a.y > b.y) - (a.y < b.y);
}

static int compare_edges(const void *a, const void *b) {
    const Edge *first = a, *second = b;
    int low = compare_ends(first->low, second->low);
    return low ? low : compare_ends(first->high, second->high);
}

static void find_borders(Tessellation *tessellation) {
    size_t count = 3 * tessellation->count;
    tessellation->sorted = memory_reserve(tessellation->sorted, &tessellation->sorted_capacity, count, sizeof(Edge));
    Edge *edges = tessellation->sorted;
    for (size_t i = 0; i < count; i++) {
        const Triangle *triangle = &tessellation->triangles[i / 3];
        Vec2 from = triangle->corners[i % 3], to = triangle->corners[(i + 1) % 3];
        bool rising = compare_ends(from, to) < 0;
        edges[i] = (Edge){rising ? from : to, rising ? to : from, i / 3, (int)(i % 3)};
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    for (size_t i = 0; i + 1 < count; i++)
        if (compare_edges(&edges[i], &edges[i + 1]) == 0)
            for (size_t k = i; k < i + 2; k++)
                tessellation->triangles[edges[k].triangle].border[edges[k].side] = false;
}

static void add_rings(Tessellation *tessellation, const Vec2 *points, const size_t *starts, size_t ring_count,
                      bool united) {
    if (!tessellation->geos)
        tessellation->geos = GEOS_init_r();
    GEOSContextHandle_t geos = tessellation->geos;
    GEOSGeometry **areas = memory_zeroed(ring_count, sizeof *areas);
    size_t count = 0;
    for (size_t r = 0; r < ring_count; r++) {
        size_t size = starts[r + 1] - starts[r];
        GEOSGeometry *area = size >= 3 ? ring_area(geos, points + starts[r], size) : NULL;
        if (area)
            areas[count++] = area;
    }
    GEOSGeometry *whole = combined(geos, areas, count, united);
    GEOSGeometry *triangles = whole ? GEOSConstrainedDelaunayTriangulation_r(geos, whole) : NULL;
    if (triangles)
        add_geometry(tessellation, triangles);
    GEOSGeom_destroy_r(geos, triangles);
    GEOSGeom_destroy_r(geos, whole);
    memory_free(areas);
    find_borders(tessellation);
}

/* Kept triangles ----------------------------------------------------------------------------------------------------*/

static void *copy_of(const void *from, size_t count, size_t size) {
    void *copy = memory_zeroed(count, size);
    memcpy(copy, from, count * size);
    return copy;
}

static void keep(Tessellation *tessellation, const Vec2 *points, const size_t *starts, size_t ring_count, bool united) {
    Tessellated *kept = &tessellation->kept[tessellation->kept_count++ % TESSELLATION_KEPT];
    release(kept);
    *kept = (Tessellated){.points = copy_of(points, starts[ring_count], sizeof *points),
                          .starts = copy_of(starts, ring_count + 1, sizeof *starts),
                          .ring_count = ring_count,
                          .united = united,
                          .triangles = copy_of(tessellation->triangles, tessellation->count, sizeof(Triangle)),
                          .count = tessellation->count};
}

/* Takes the triangles of these very rings, if they are kept. */
static bool recall(Tessellation *tessellation, const Vec2 *points, const size_t *starts, size_t ring_count,
                   bool united) {
    for (size_t i = 0; i < TESSELLATION_KEPT; i++) {
        const Tessellated *kept = &tessellation->kept[i];
        bool same = kept->starts && kept->ring_count == ring_count && kept->united == united &&
                    memcmp(kept->starts, starts, (ring_count + 1) * sizeof *starts) == 0 &&
                    memcmp(kept->points, points, starts[ring_count] * sizeof *points) == 0;
        if (!same)
            continue;
        tessellation->triangles = memory_reserve(tessellation->triangles, &tessellation->capacity, kept->count,
                                                 sizeof *tessellation->triangles);
        memcpy(tessellation->triangles, kept->triangles, kept->count * sizeof *kept->triangles);
        tessellation->count = kept->count;
        return true;
    }
    return false;
}

void tessellation_make(Tessellation *tessellation, const Vec2 *points, const size_t *starts, size_t ring_count,
                       bool united) {
    tessellation->count = 0;
    if (!ring_count)
        return;
    size_t first = starts[1] - starts[0];
    Vec2 middle = middle_of(points + starts[0], first);
    if (ring_count == 1 && first == 4 && add_halves(tessellation, points + starts[0]))
        return;
    if (ring_count == 1 && first >= 3 && is_seen_from(middle, points + starts[0], first)) {
        add_fan(tessellation, middle, points + starts[0], first);
    } else if (!recall(tessellation, points, starts, ring_count, united)) {
        add_rings(tessellation, points, starts, ring_count, united);
        if (starts[ring_count] <= TESSELLATION_LARGEST)
            keep(tessellation, points, starts, ring_count, united);
    }
}
