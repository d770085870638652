#include "exchange/walkable.h"

#include <stdio.h>
#include <string.h>

#include "plan/plan_geometry.h"
#include "space/solids.h"

static const double MARGIN = 1;   /* m, around the plan: allows paths past an open door */
static const double SPECK = 1e-4; /* m2: a smaller part of the area is a rounding error */
static const double HALF_LEAST =
    5e-4; /* m: half the thickness given to a wall of zero thickness that ends within the area */

enum {
    MOST_MET = 8000,  /* points of walls of zero thickness: each is compared with all of them */
    MOST_CELLS = 5000 /* cells into which walls of zero thickness cut the area; each is compared with all others */
};

typedef struct Area {
    GEOSContextHandle_t geos;
    const Plan *plan;
    Solids solids;
    Box box;
    GEOSGeometry *solid; /* everything with a thickness */
    GEOSGeometry *whole; /* the box without `solid` */
    GEOSGeometry *lines; /* walls of zero thickness with doors cut out, or NULL */
    GEOSGeometry *cells; /* the parts that `lines` cut the area into */
} Area;

/* Geometry -------------------------------------------------------------------------------------------------------- */

static GEOSGeometry *box_polygon(GEOSContextHandle_t geos, Box box) {
    return GEOSGeom_createRectangle_r(geos, box.low.x, box.low.y, box.high.x, box.high.y);
}

static Box box_of_plan(const Plan *plan, GEOSContextHandle_t geos, const GEOSGeometry *solid) {
    Box box = box_empty();
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t i = 0; i < plan->walls[w].points.count; i++)
            box = box_include(box, plan->walls[w].points.at[i]);
    if (GEOSisEmpty_r(geos, solid) == 0) {
        Box own;
        GEOSGeom_getXMin_r(geos, solid, &own.low.x);
        GEOSGeom_getXMax_r(geos, solid, &own.high.x);
        GEOSGeom_getYMin_r(geos, solid, &own.low.y);
        GEOSGeom_getYMax_r(geos, solid, &own.high.y);
        box = box_include(box_include(box, own.low), own.high);
    }
    return box_expand(box, MARGIN);
}

/* Returns the lines with a common point where they nearly meet: in a turned plan the end of a wall lies a rounding
 * error off the wall that it meets, and the area would leak there. */
static GEOSGeometry *meet_exactly(GEOSContextHandle_t geos, const GEOSGeometry *lines) {
    return GEOSGetNumCoordinates_r(geos, lines) <= MOST_MET ? GEOSSnap_r(geos, lines, lines, SOLIDS_GRID)
                                                            : GEOSGeom_clone_r(geos, lines);
}

/* Collects walls of zero thickness; NULL if there are none. */
static GEOSGeometry *find_lines(Area *area) {
    GEOSGeometry **list = memory_zeroed(area->plan->wall_count, sizeof *list);
    unsigned count = 0;
    for (size_t w = 0; w < area->plan->wall_count; w++) {
        GEOSGeometry *line =
            area->plan->walls[w].thickness > 0 ? NULL : solids_thin_wall(&area->solids, w, area->solid);
        if (line)
            list[count++] = line;
    }
    GEOSGeometry *all = GEOSGeom_createCollection_r(area->geos, GEOS_GEOMETRYCOLLECTION, list, count);
    GEOSGeometry *met = all ? meet_exactly(area->geos, all) : NULL;
    GEOSGeometry *united = count && met ? GEOSUnaryUnion_r(area->geos, met) : NULL;
    GEOSGeom_destroy_r(area->geos, met);
    GEOSGeom_destroy_r(area->geos, all);
    memory_free(list);
    return united;
}

/* Returns the cells without the thin strips that open-ended walls take away. */
static GEOSGeometry *less_loose_ends(Area *area, GEOSGeometry *cells, GEOSGeometry *loose) {
    GEOSGeometry *joined = GEOSLineMerge_r(area->geos, loose); /* joined first, so that corners have no notches */
    GEOSGeometry *thin =
        joined ? GEOSBufferWithStyle_r(area->geos, joined, HALF_LEAST, 8, GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, 5)
               : NULL;
    GEOSGeom_destroy_r(area->geos, joined);
    int count = GEOSGetNumGeometries_r(area->geos, cells);
    GEOSGeometry **list = memory_zeroed((size_t)count, sizeof *list);
    unsigned made = 0;
    for (int i = 0; i < count && thin; i++) {
        GEOSGeometry *rest = GEOSDifference_r(area->geos, GEOSGetGeometryN_r(area->geos, cells, i), thin);
        if (rest)
            list[made++] = rest;
    }
    GEOSGeometry *all = thin && made == (unsigned)count
                            ? GEOSGeom_createCollection_r(area->geos, GEOS_GEOMETRYCOLLECTION, list, made)
                            : NULL;
    for (unsigned i = 0; i < made && !all; i++)
        GEOSGeom_destroy_r(area->geos, list[i]);
    memory_free(list);
    GEOSGeom_destroy_r(area->geos, thin);
    GEOSGeom_destroy_r(area->geos, cells);
    return all;
}

static bool is_there(const Area *area, const GEOSGeometry *geometry) {
    return geometry && GEOSisEmpty_r(area->geos, geometry) == 0;
}

/* Returns the cells that the edges of the area and the lines enclose. */
static GEOSGeometry *cut_cells(Area *area) {
    GEOSContextHandle_t geos = area->geos;
    GEOSGeometry *edge = GEOSBoundary_r(geos, area->whole);
    GEOSGeometry *noded = edge ? GEOSUnion_r(geos, edge, area->lines) : NULL;
    GEOSGeometry *cuts = NULL, *dangles = NULL, *invalid = NULL;
    GEOSGeometry *cells = noded ? GEOSPolygonize_full_r(geos, noded, &cuts, &dangles, &invalid) : NULL;
    GEOSGeometry *loose[2] = {cuts, dangles};
    for (int i = 0; i < 2; i++)
        if (cells && is_there(area, loose[i]))
            cells = less_loose_ends(area, cells, loose[i]);
    GEOSGeom_destroy_r(geos, cuts);
    GEOSGeom_destroy_r(geos, dangles);
    GEOSGeom_destroy_r(geos, invalid);
    GEOSGeom_destroy_r(geos, noded);
    GEOSGeom_destroy_r(geos, edge);
    return cells;
}

/* Which cells are walkable ---------------------------------------------------------------------------------------- */

typedef struct Cell {
    GEOSGeometry *shape; /* a polygon; owned */
    GEOSGeometry *hull;  /* without its holes; owned */
    GEOSGeometry *inner; /* a point in it; owned */
    bool outside;        /* touches the edge of the box */
    bool inhabited;
    int depth; /* number of other cells' holes that contain it */
} Cell;

typedef struct Cells {
    Cell *list; /* (count) */
    size_t count, capacity;
} Cells;

static bool holds(const Area *area, const GEOSGeometry *shape, Vec2 at) {
    GEOSGeometry *point = GEOSGeom_createPointFromXY_r(area->geos, at.x, at.y);
    bool inside = point && GEOSIntersects_r(area->geos, shape, point) == 1;
    GEOSGeom_destroy_r(area->geos, point);
    return inside;
}

/* True if a person stands in the shape or an openable door leads into it. */
static bool is_inhabited(const Area *area, const GEOSGeometry *shape) {
    const Plan *plan = area->plan;
    bool found = false;
    for (size_t p = 0; p < plan->person_count && !found; p++)
        found = holds(area, shape, plan->people[p].at);
    for (size_t c = 0; c < plan->crowd_count && !found; c++) {
        Vec2 sum = {0, 0};
        for (size_t i = 0; i < plan->crowds[c].area.count; i++)
            sum = vec2_add(sum, plan->crowds[c].area.at[i]);
        found = holds(area, shape, vec2_scale(sum, 1 / (double)plan->crowds[c].area.count));
    }
    for (size_t d = 0; d < plan->door_count && !found; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        found = plan->doors[d].state != DOOR_LOCKED && holds(area, shape, vec2_scale(vec2_add(from, to), 0.5));
    }
    return found;
}

static void add_cells(const Area *area, const GEOSGeometry *geometry, Cells *cells) {
    GEOSContextHandle_t geos = area->geos;
    if (GEOSisEmpty_r(geos, geometry) != 0 || cells->count > MOST_CELLS)
        return;
    if (GEOSGeomTypeId_r(geos, geometry) != GEOS_POLYGON) {
        for (int i = 0; i < GEOSGetNumGeometries_r(geos, geometry); i++)
            if (GEOSGetGeometryN_r(geos, geometry, i) != geometry)
                add_cells(area, GEOSGetGeometryN_r(geos, geometry, i), cells);
        return;
    }
    double left = HUGE_VAL;
    GEOSGeom_getXMin_r(geos, geometry, &left);
    Cell cell = {
        .shape = GEOSGeom_clone_r(geos, geometry),
        .hull = GEOSGeom_createPolygon_r(geos, GEOSGeom_clone_r(geos, GEOSGetExteriorRing_r(geos, geometry)), NULL, 0),
        .inner = GEOSPointOnSurface_r(geos, geometry),
        .outside = left <= area->box.low.x,
        .inhabited = is_inhabited(area, geometry)};
    bool is_free = cell.shape && cell.hull && cell.inner && GEOSIntersects_r(geos, area->whole, cell.inner) == 1;
    cells->list = memory_reserve(cells->list, &cells->capacity, cells->count + 1, sizeof *cells->list);
    cells->list[cells->count] = cell;
    cells->count += is_free;
    if (!is_free) {
        GEOSGeom_destroy_r(geos, cell.shape);
        GEOSGeom_destroy_r(geos, cell.hull);
        GEOSGeom_destroy_r(geos, cell.inner);
    }
}

static void find_depths(const Area *area, Cells *cells) {
    for (size_t i = 0; i < cells->count; i++) {
        const GEOSPreparedGeometry *hull = GEOSPrepare_r(area->geos, cells->list[i].hull);
        for (size_t j = 0; j < cells->count && hull; j++)
            cells->list[j].depth += j != i && GEOSPreparedIntersects_r(area->geos, hull, cells->list[j].inner) == 1;
        GEOSPreparedGeom_destroy_r(area->geos, hull);
    }
}

/* Inside the outermost walls is walkable, inside an obstacle there is not, and so on alternately; a cell with a
 * person in it is always walkable. A speck between a line and a wall that it meets is not. */
static bool is_walkable(const Area *area, const Cell *cell, bool outside_too) {
    double size = 0;
    GEOSArea_r(area->geos, cell->shape, &size);
    return cell->inhabited || (size >= SPECK && cell->depth % 2 == (outside_too ? 0 : 1));
}

static GEOSGeometry *choose_cells(const Area *area, Cells *cells) {
    bool inner = false, outside_too = false;
    find_depths(area, cells);
    for (size_t i = 0; i < cells->count; i++) {
        inner |= !cells->list[i].outside;
        outside_too |= cells->list[i].outside && cells->list[i].inhabited;
    }
    GEOSGeometry **kept = memory_zeroed(cells->count, sizeof *kept);
    unsigned count = 0;
    for (size_t i = 0; i < cells->count; i++) {
        Cell *cell = &cells->list[i];
        if (!is_walkable(area, cell, outside_too || !inner))
            continue;
        kept[count++] = cell->shape;
        cell->shape = NULL;
    }
    GEOSGeometry *all = GEOSGeom_createCollection_r(area->geos, GEOS_MULTIPOLYGON, kept, count);
    memory_free(kept);
    return all;
}

/* Text ------------------------------------------------------------------------------------------------------------ */

static char *text_of(const Area *area, const GEOSGeometry *geometry) {
    GEOSWKTWriter *writer = GEOSWKTWriter_create_r(area->geos);
    GEOSWKTWriter_setTrim_r(area->geos, writer, 1);
    char *text = GEOSWKTWriter_write_r(area->geos, writer, geometry), *copy = NULL;
    if (text)
        copy = strcpy(memory_zeroed(strlen(text) + 2, 1), text);
    if (copy)
        strcat(copy, "\n");
    GEOSFree_r(area->geos, text);
    GEOSWKTWriter_destroy_r(area->geos, writer);
    return copy;
}

/* Merges parts with a common side, which a MULTIPOLYGON must not have. */
static char *write_area(const Area *area, GEOSGeometry *all) {
    GEOSContextHandle_t geos = area->geos;
    int count = GEOSGetNumGeometries_r(geos, all);
    GEOSNormalize_r(geos, all); /* a canonical order of the rings' points */
    if (count == 1)
        return text_of(area, GEOSGetGeometryN_r(geos, all, 0));
    if (GEOSisValid_r(geos, all) == 1)
        return text_of(area, all);
    GEOSGeometry **parts = memory_zeroed((size_t)count, sizeof *parts);
    for (int i = 0; i < count; i++)
        parts[i] = GEOSGeom_clone_r(geos, GEOSGetGeometryN_r(geos, all, i));
    GEOSGeometry *collection = GEOSGeom_createCollection_r(geos, GEOS_GEOMETRYCOLLECTION, parts, (unsigned)count);
    char *text = collection ? text_of(area, collection) : NULL;
    GEOSGeom_destroy_r(geos, collection);
    memory_free(parts);
    return text;
}

/* The whole ------------------------------------------------------------------------------------------------------- */

static char *wkt_of(Area *area) {
    GEOSContextHandle_t geos = area->geos;
    area->solid = solids_unite(&area->solids);
    if (!area->solid)
        return NULL;
    area->box = box_of_plan(area->plan, geos, area->solid);
    GEOSGeometry *box = box_polygon(geos, area->box);
    area->whole = box ? GEOSDifference_r(geos, box, area->solid) : NULL;
    GEOSGeom_destroy_r(geos, box);
    if (!area->whole)
        return NULL;
    area->lines = find_lines(area);
    area->cells = is_there(area, area->lines) ? cut_cells(area) : GEOSGeom_clone_r(geos, area->whole);
    Cells cells = {0};
    if (area->cells)
        add_cells(area, area->cells, &cells);
    if (cells.count > MOST_CELLS)
        snprintf(area->solids.message, sizeof area->solids.message,
                 "walls of no thickness cut it into more than %d parts, must be fewer", MOST_CELLS);
    GEOSGeometry *all = cells.count && cells.count <= MOST_CELLS ? choose_cells(area, &cells) : NULL;
    char *text = all ? write_area(area, all) : NULL;
    GEOSGeom_destroy_r(geos, all);
    for (size_t i = 0; i < cells.count; i++) {
        GEOSGeom_destroy_r(geos, cells.list[i].shape);
        GEOSGeom_destroy_r(geos, cells.list[i].hull);
        GEOSGeom_destroy_r(geos, cells.list[i].inner);
    }
    memory_free(cells.list);
    return text;
}

char *walkable_wkt(const Plan *plan, Fault *fault) {
    Area area = {.plan = plan};
    solids_init(&area.solids, plan);
    area.geos = area.solids.geos;
    char *text = wkt_of(&area);
    if (!text)
        fault_add(fault, "%s:1:1: the walkable area cannot be computed%s%s", plan->path,
                  *area.solids.message ? ": " : "", area.solids.message);
    GEOSGeom_destroy_r(area.geos, area.cells);
    GEOSGeom_destroy_r(area.geos, area.lines);
    GEOSGeom_destroy_r(area.geos, area.whole);
    GEOSGeom_destroy_r(area.geos, area.solid);
    solids_clear(&area.solids);
    return text;
}
