#include "space/unite.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/vec2.h"

/* GEOS sorts the polygons by place (a sort-tile-recursive tree), halves that sequence again and again, and unites the
 * halves from the bottom up. Each union nodes every edge of both halves, although most polygons of a house meet none
 * of the other half. Here each union is given only the polygons whose boxes do; the others stay as they are, for what
 * is on the grid and noded does not change again, except that each union lets every ring begin one point later. A
 * polygon that was in no union yet is brought into the form that one would give it: on the grid, and clockwise.
 *
 * A union returns its polygons in the order of their first edges in its inputs, which end where the ring begins. So
 * each of them takes the place of the first input on whose boundary its last edge lies, among those that stay. */

enum {
    NODE_CAPACITY = 10, /* of the tree, as in a union of GEOS */
    MOST = 2000,        /* polygons, whose pairs are tried */
    CORNERS = 5         /* of a quadrangle, the first one twice */
};

#define APART 10.0 /* 1, grid spacings: polygons farther apart do not meet */
#define ON 5.0     /* 1, grid spacings between an edge and the boundary on which it lies */
#define THICK 10.0 /* 1, grid spacings: the thickness and the sides of a quadrangle that need not be united */

typedef struct Piece {
    GEOSGeometry *polygon; /* owned */
    Box box;
    size_t later; /* points by which its rings have yet to begin later */
    bool fresh;   /* True if it was in no union yet */
    bool touches; /* True if its rings touch themselves or others at a corner: how they are linked may change */
    bool joins;   /* True if it takes part in the union at hand */
} Piece;

typedef struct Pieces {
    Piece *at; /* (count) */
    size_t count, capacity;
} Pieces;

typedef struct Unite {
    GEOSContextHandle_t geos;
    double grid;
    bool failed;
    Pieces all;       /* fresh, in the order of the collection */
    size_t *sequence; /* (all.count) of them, by place */
    size_t sequenced;
} Unite;

static void add_piece(Pieces *pieces, Piece piece) {
    pieces->at = memory_reserve(pieces->at, &pieces->capacity, pieces->count + 1, sizeof *pieces->at);
    pieces->at[pieces->count++] = piece;
}

static void clear(const Unite *unite, Pieces *pieces) {
    for (size_t i = 0; i < pieces->count; i++)
        GEOSGeom_destroy_r(unite->geos, pieces->at[i].polygon);
    memory_free(pieces->at);
    *pieces = (Pieces){0};
}

/* Adds the polygons of a geometry. Fails if there is anything else in it, or nothing. */
static void add_polygons(Unite *unite, const GEOSGeometry *geometry, bool fresh, Pieces *pieces) {
    GEOSContextHandle_t geos = unite->geos;
    int type = GEOSGeomTypeId_r(geos, geometry);
    if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
        for (int i = 0; i < GEOSGetNumGeometries_r(geos, geometry); i++)
            add_polygons(unite, GEOSGetGeometryN_r(geos, geometry, i), fresh, pieces);
        return;
    }
    Piece piece = {.fresh = fresh};
    if (type != GEOS_POLYGON || !GEOSGeom_getExtent_r(geos, geometry, &piece.box.low.x, &piece.box.low.y,
                                                      &piece.box.high.x, &piece.box.high.y)) {
        unite->failed = true;
        return;
    }
    piece.polygon = GEOSGeom_clone_r(geos, geometry);
    unite->failed |= !piece.polygon;
    add_piece(pieces, piece);
}

static void add_to_sequence(void *item, void *context) {
    Unite *unite = context;
    unite->sequence[unite->sequenced++] = (size_t)((Piece *)item - unite->all.at);
}

static void ignore(void *item, void *context) {
    (void)item;
    (void)context;
}

static void sort_by_place(Unite *unite) {
    GEOSSTRtree *tree = GEOSSTRtree_create_r(unite->geos, NODE_CAPACITY);
    for (size_t i = 0; i < unite->all.count; i++)
        GEOSSTRtree_insert_r(unite->geos, tree, unite->all.at[i].polygon, &unite->all.at[i]);
    GEOSSTRtree_query_r(unite->geos, tree, unite->all.at[0].polygon, ignore, NULL); /* which sorts it */
    unite->sequence = memory_zeroed(unite->all.count, sizeof *unite->sequence);
    GEOSSTRtree_iterate_r(unite->geos, tree, add_to_sequence, unite);
    GEOSSTRtree_destroy_r(unite->geos, tree);
    unite->failed |= unite->sequenced != unite->all.count;
}

/* True if two polygons meet, or nearly. */
static bool meet(const Unite *unite, const Piece *a, const Piece *b) {
    double apart = APART * unite->grid;
    return a->box.low.x <= b->box.high.x + apart && b->box.low.x <= a->box.high.x + apart &&
           a->box.low.y <= b->box.high.y + apart && b->box.low.y <= a->box.high.y + apart &&
           GEOSDistanceWithin_r(unite->geos, a->polygon, b->polygon, apart);
}

/* True if two corners that follow one another are next to the same point of the grid, or nearly. */
static bool has_short_side(const Unite *unite, const Piece *piece) {
    GEOSContextHandle_t geos = unite->geos;
    const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(geos, GEOSGetExteriorRing_r(geos, piece->polygon));
    bool is_short = false;
    for (unsigned i = 0; i + 1 < CORNERS; i++) {
        Vec2 from, to;
        GEOSCoordSeq_getXY_r(geos, sequence, i, &from.x, &from.y);
        GEOSCoordSeq_getXY_r(geos, sequence, i + 1, &to.x, &to.y);
        is_short |= vec2_distance(from, to) < THICK * unite->grid;
    }
    return is_short;
}

/* True if the polygon is a quadrangle, which `settle` can handle: it does not cross itself and is thick enough that no
 * corners fall together when they are rounded. */
static bool is_plain(const Unite *unite, const Piece *piece) {
    GEOSContextHandle_t geos = unite->geos;
    double area = 0, length = 0;
    return GEOSGetNumInteriorRings_r(geos, piece->polygon) == 0 &&
           GEOSGetNumCoordinates_r(geos, piece->polygon) == CORNERS && GEOSisValid_r(geos, piece->polygon) == 1 &&
           GEOSArea_r(geos, piece->polygon, &area) && GEOSLength_r(geos, piece->polygon, &length) &&
           area > THICK * unite->grid * length && !has_short_side(unite, piece);
}

/* Chooses the polygons of both halves, whose first `half` are those of the first one, that a union is needed for.
 * Returns their number. */
static size_t choose(const Unite *unite, Pieces *pieces, size_t half) {
    size_t joining = 0;
    for (size_t i = 0; i < pieces->count; i++)
        pieces->at[i].joins = pieces->at[i].touches || (pieces->at[i].fresh && !is_plain(unite, &pieces->at[i]));
    for (size_t i = 0; i < half; i++)
        for (size_t j = half; j < pieces->count; j++)
            if (meet(unite, &pieces->at[i], &pieces->at[j]))
                pieces->at[i].joins = pieces->at[j].joins = true;
    for (size_t i = 0; i < pieces->count; i++)
        joining += pieces->at[i].joins;
    return joining;
}

/* Returns a ring that begins `later` points later, or the opposite one, from its last point but one. */
static GEOSGeometry *ring_from(const Unite *unite, const GEOSGeometry *ring, size_t later, bool opposite) {
    GEOSContextHandle_t geos = unite->geos;
    const GEOSCoordSequence *from = GEOSGeom_getCoordSeq_r(geos, ring);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(geos, from, &size);
    GEOSCoordSequence *to = GEOSCoordSeq_create_r(geos, size, 2);
    for (unsigned i = 0; i < size; i++) {
        unsigned at = (unsigned)((i + later) % (size - 1));
        double x, y;
        GEOSCoordSeq_getXY_r(geos, from, opposite ? size - 2 - at : at, &x, &y);
        GEOSCoordSeq_setXY_r(geos, to, i, x, y);
    }
    return GEOSGeom_createLinearRing_r(geos, to);
}

/* Returns the polygon of a piece, whose rings begin where they should; the caller destroys it. */
static GEOSGeometry *polygon_of(const Unite *unite, const Piece *piece) {
    GEOSContextHandle_t geos = unite->geos;
    if (!piece->later)
        return GEOSGeom_clone_r(geos, piece->polygon);
    int count = GEOSGetNumInteriorRings_r(geos, piece->polygon);
    GEOSGeometry **holes = memory_zeroed((size_t)count, sizeof(GEOSGeometry *));
    for (int i = 0; i < count; i++)
        holes[i] = ring_from(unite, GEOSGetInteriorRingN_r(geos, piece->polygon, i), piece->later, false);
    GEOSGeometry *shell = ring_from(unite, GEOSGetExteriorRing_r(geos, piece->polygon), piece->later, false);
    GEOSGeometry *polygon = GEOSGeom_createPolygon_r(geos, shell, holes, (unsigned)count);
    memory_free(holes);
    return polygon;
}

/* Rounds a coordinate as GEOS does, halves upwards. */
static double rounded(double value, double parts) {
    double exact = value * parts, whole = trunc(exact), rest = exact - whole;
    return (rest >= 0.5 ? whole + 1 : rest < -0.5 ? whole - 1 : whole) / parts;
}

/* Brings a quadrangle that meets no other one into the form that a union would give it. */
static void settle(Unite *unite, Piece *piece) {
    GEOSContextHandle_t geos = unite->geos;
    const GEOSCoordSequence *from = GEOSGeom_getCoordSeq_r(geos, GEOSGetExteriorRing_r(geos, piece->polygon));
    GEOSCoordSequence *sequence = GEOSCoordSeq_clone_r(geos, from);
    for (unsigned i = 0; i < CORNERS; i++) {
        double x, y;
        GEOSCoordSeq_getXY_r(geos, from, i, &x, &y);
        GEOSCoordSeq_setXY_r(geos, sequence, i, rounded(x, 1 / unite->grid), rounded(y, 1 / unite->grid));
    }
    char counterclockwise = 0;
    unite->failed |= !GEOSCoordSeq_isCCW_r(geos, sequence, &counterclockwise);
    GEOSGeometry *ring = GEOSGeom_createLinearRing_r(geos, sequence);
    GEOSGeom_destroy_r(geos, piece->polygon);
    piece->polygon =
        GEOSGeom_createPolygon_r(geos, ring_from(unite, ring, !counterclockwise, counterclockwise), NULL, 0);
    piece->fresh = false;
    unite->failed |= !piece->polygon;
    GEOSGeom_destroy_r(geos, ring);
}

/* Returns the joining polygons from `first` to `end` - 1 as one geometry. */
static GEOSGeometry *joining_of(const Unite *unite, const Pieces *pieces, size_t first, size_t end) {
    GEOSGeometry **parts = memory_zeroed(end - first, sizeof(GEOSGeometry *));
    unsigned count = 0;
    for (size_t i = first; i < end; i++)
        if (pieces->at[i].joins)
            parts[count++] = polygon_of(unite, &pieces->at[i]);
    GEOSGeometry *all =
        count == 1 ? parts[0] : GEOSGeom_createCollection_r(unite->geos, GEOS_MULTIPOLYGON, parts, count);
    memory_free(parts);
    return all;
}

/* Returns the first of the joining inputs on whose boundary the last edge of a polygon lies, or their number. */
static size_t source_of(const Unite *unite, const Piece *piece, const Pieces *inputs) {
    GEOSContextHandle_t geos = unite->geos;
    const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(geos, GEOSGetExteriorRing_r(geos, piece->polygon));
    Vec2 a, b;
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(geos, sequence, &size);
    GEOSCoordSeq_getXY_r(geos, sequence, size - 2, &a.x, &a.y);
    GEOSCoordSeq_getXY_r(geos, sequence, size - 1, &b.x, &b.y);
    Vec2 middle = vec2_scale(vec2_add(a, b), 0.5);
    GEOSGeometry *point = GEOSGeom_createPointFromXY_r(geos, middle.x, middle.y);
    size_t source = 0;
    for (; source < inputs->count; source++) {
        const Piece *input = &inputs->at[source];
        double distance = HUGE_VAL;
        if (input->joins && box_holds(box_expand(input->box, ON * unite->grid), middle) &&
            GEOSDistance_r(geos, GEOSGetExteriorRing_r(geos, input->polygon), point, &distance) &&
            distance < ON * unite->grid)
            break;
    }
    GEOSGeom_destroy_r(geos, point);
    return source;
}

typedef struct RingPoint {
    Vec2 at;
    size_t piece;
} RingPoint;

static int compare_points(const void *a, const void *b) {
    const RingPoint *p = a, *q = b;
    int by_x = (p->at.x > q->at.x) - (p->at.x < q->at.x);
    return by_x ? by_x : (p->at.y > q->at.y) - (p->at.y < q->at.y);
}

/* Marks the polygons that have a corner in common with themselves or with others. */
static void mark_touching(const Unite *unite, Pieces *pieces) {
    GEOSContextHandle_t geos = unite->geos;
    RingPoint *points = NULL;
    size_t count = 0, capacity = 0;
    for (size_t p = 0; p < pieces->count; p++) {
        const GEOSGeometry *polygon = pieces->at[p].polygon;
        for (int r = -1; r < GEOSGetNumInteriorRings_r(geos, polygon); r++) {
            const GEOSGeometry *ring =
                r < 0 ? GEOSGetExteriorRing_r(geos, polygon) : GEOSGetInteriorRingN_r(geos, polygon, r);
            const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(geos, ring);
            unsigned size = 0;
            GEOSCoordSeq_getSize_r(geos, sequence, &size);
            points = memory_reserve(points, &capacity, count + size, sizeof *points);
            for (unsigned i = 0; i + 1 < size; i++) {
                GEOSCoordSeq_getXY_r(geos, sequence, i, &points[count].at.x, &points[count].at.y);
                points[count++].piece = p;
            }
        }
    }
    if (count)
        qsort(points, count, sizeof *points, compare_points);
    for (size_t i = 1; i < count; i++)
        if (compare_points(&points[i - 1], &points[i]) == 0)
            pieces->at[points[i - 1].piece].touches = pieces->at[points[i].piece].touches = true;
    memory_free(points);
}

/* Puts the polygons of a union in the places of their sources, among those that did not join. Takes both over. */
static Pieces put_in_place(Unite *unite, Pieces *inputs, Pieces *united) {
    Pieces all = {0};
    size_t done = 0;
    for (size_t u = 0; u <= united->count; u++) {
        size_t source = u < united->count ? source_of(unite, &united->at[u], inputs) : inputs->count;
        unite->failed |= u < united->count && (source == inputs->count || source < done);
        for (; done < source; done++) {
            if (!inputs->at[done].joins) {
                add_piece(&all, inputs->at[done]);
                inputs->at[done].polygon = NULL;
            }
        }
        if (u < united->count) {
            add_piece(&all, united->at[u]);
            united->at[u].polygon = NULL;
        }
    }
    clear(unite, inputs);
    clear(unite, united);
    return all;
}

/* Unites two halves, the first `half` of the pieces and the rest. Takes them over. */
static Pieces unite_halves(Unite *unite, Pieces *pieces, size_t half) {
    size_t joining = unite->failed ? 0 : choose(unite, pieces, half);
    for (size_t i = 0; i < pieces->count && !unite->failed; i++) {
        Piece *piece = &pieces->at[i];
        if (piece->fresh && !piece->joins)
            settle(unite, piece);
        else if (!piece->joins)
            piece->later++;
    }
    if (!joining || unite->failed)
        return *pieces;
    GEOSGeometry *one = joining_of(unite, pieces, 0, half), *other = joining_of(unite, pieces, half, pieces->count);
    GEOSGeometry *both = one && other ? GEOSUnionPrec_r(unite->geos, one, other, unite->grid) : NULL;
    GEOSGeom_destroy_r(unite->geos, one);
    GEOSGeom_destroy_r(unite->geos, other);
    Pieces united = {0};
    if (both)
        add_polygons(unite, both, false, &united);
    unite->failed |= !both;
    GEOSGeom_destroy_r(unite->geos, both);
    if (unite->failed) {
        clear(unite, &united);
        return *pieces;
    }
    mark_touching(unite, &united);
    return put_in_place(unite, pieces, &united);
}

/* Unites the polygons first to end - 1 of the sequence. */
static Pieces unite_range(Unite *unite, size_t first, size_t end) {
    Pieces pieces = {0};
    if (end - first == 1) {
        Piece *piece = &unite->all.at[unite->sequence[first]];
        add_piece(&pieces, *piece);
        piece->polygon = NULL;
        return pieces;
    }
    size_t middle = (first + end) / 2;
    pieces = unite_range(unite, first, middle);
    size_t half = pieces.count;
    Pieces rest = unite_range(unite, middle, end);
    for (size_t i = 0; i < rest.count; i++)
        add_piece(&pieces, rest.at[i]);
    memory_free(rest.at);
    return unite_halves(unite, &pieces, half);
}

static GEOSGeometry *as_geometry(const Unite *unite, const Pieces *pieces) {
    GEOSGeometry **parts = memory_zeroed(pieces->count, sizeof(GEOSGeometry *));
    for (size_t i = 0; i < pieces->count; i++)
        parts[i] = polygon_of(unite, &pieces->at[i]);
    GEOSGeometry *all = GEOSGeom_createCollection_r(unite->geos, GEOS_MULTIPOLYGON, parts, (unsigned)pieces->count);
    memory_free(parts);
    return all;
}

GEOSGeometry *unite_polygons(GEOSContextHandle_t geos, const GEOSGeometry *collection, double grid) {
    Unite unite = {.geos = geos, .grid = grid};
    GEOSGeometry *united = NULL;
    add_polygons(&unite, collection, true, &unite.all);
    if (!unite.failed && unite.all.count > 1 && unite.all.count <= MOST) {
        sort_by_place(&unite);
        Pieces pieces = {0};
        if (!unite.failed)
            pieces = unite_range(&unite, 0, unite.all.count);
        if (!unite.failed)
            united = as_geometry(&unite, &pieces);
        clear(&unite, &pieces);
    }
    clear(&unite, &unite.all);
    memory_free(unite.sequence);
    return united ? united : GEOSUnaryUnionPrec_r(geos, collection, grid);
}
