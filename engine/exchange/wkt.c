#include "exchange/wkt.h"

#include <ctype.h>
#include <errno.h>
#define GEOS_USE_ONLY_R_API
#include <geos_c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "exchange/plan_size.h"
#include "mechanics/broadphase.h"

enum {
    LARGEST_FILE = 16 * 1024 * 1024, /* bytes: four times the largest number of wall points */
    DEEPEST = 32,                    /* nested brackets; GEOS would recurse until the stack overflows */
    MOST_MET = 8000,                 /* points of areas that are brought together: each is compared with all */
    MOST_UNITED = 50000,             /* points of areas that are united */
    MOST_MEETINGS = 400000,          /* pairs of sides whose boxes overlap: each may be a crossing */
};

static const double ADJOINING = 1e-6; /* m: two areas at most this far apart adjoin */
static const double DEGREES = 0.01;   /* degree: a house is smaller, and no house has so few metres */
static const double FARTHEST = 1e8;   /* m */
static const double REPEATED = 0.01;  /* 1: overlap of areas as a share of their union */

typedef struct Reader {
    HouseBuilder *builder;
    GEOSContextHandle_t geos;
    GEOSWKTReader *wkt;
    char message[200];    /* last message of GEOS */
    GEOSGeometry **areas; /* (count) polygons */
    size_t count, capacity;
    size_t points; /* points in all areas */
    double unit;   /* m */
} Reader;

static void remember_message(const char *message, void *context) {
    Reader *reader = context;
    const char *colon = strstr(message, "Exception: ");
    snprintf(reader->message, sizeof reader->message, "%s", colon ? colon + strlen("Exception: ") : message);
    reader->message[strcspn(reader->message, "\n")] = 0;
}

static bool fail(Reader *reader, const char *what) {
    return house_builder_fail(reader->builder, "%s%s%s", what, *reader->message ? ": " : "", reader->message);
}

/* Geometry to walls ----------------------------------------------------------------------------------------------- */

static bool add_line(Reader *reader, const GEOSGeometry *line) {
    const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(reader->geos, line);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(reader->geos, sequence, &count);
    Vec2 *points = memory_zeroed(count, sizeof *points);
    for (unsigned i = 0; i < count; i++) {
        GEOSCoordSeq_getXY_r(reader->geos, sequence, i, &points[i].x, &points[i].y);
        points[i] = vec2_scale(points[i], reader->unit);
    }
    house_builder_wall(reader->builder, points, count, 0, 0);
    memory_free(points);
    return !reader->builder->failed;
}

static bool add_area(Reader *reader, const GEOSGeometry *polygon) {
    bool good = add_line(reader, GEOSGetExteriorRing_r(reader->geos, polygon));
    for (int i = 0; good && i < GEOSGetNumInteriorRings_r(reader->geos, polygon); i++)
        good = add_line(reader, GEOSGetInteriorRingN_r(reader->geos, polygon, i));
    return good;
}

static bool check_area(Reader *reader, const GEOSGeometry *polygon) {
    double low_x, high_x, low_y, high_y;
    bool has_box =
        GEOSGeom_getXMin_r(reader->geos, polygon, &low_x) && GEOSGeom_getXMax_r(reader->geos, polygon, &high_x) &&
        GEOSGeom_getYMin_r(reader->geos, polygon, &low_y) && GEOSGeom_getYMax_r(reader->geos, polygon, &high_y);
    if (!has_box)
        return fail(reader, "an area lies nowhere");
    if (!house_builder_good(reader->builder, vec2_scale(vec2(low_x, low_y), reader->unit)) ||
        !house_builder_good(reader->builder, vec2_scale(vec2(high_x, high_y), reader->unit)))
        return false;
    if (GEOSisValid_r(reader->geos, polygon) == 1)
        return true;
    char *reason = GEOSisValidReason_r(reader->geos, polygon);
    snprintf(reader->message, sizeof reader->message, "%s", reason ? reason : "");
    GEOSFree_r(reader->geos, reason);
    return fail(reader, "an area's rings must not cross or touch along a side");
}

/* Keeps the polygons of a geometry and adds its lines as walls. */
static bool sort_out(Reader *reader, const GEOSGeometry *geometry) {
    int type = GEOSGeomTypeId_r(reader->geos, geometry);
    if (GEOSisEmpty_r(reader->geos, geometry) == 1) {
        import_report_leave(reader->builder->report, 1, "empty shapes");
        return true;
    }
    if (type == GEOS_POINT) {
        import_report_leave(reader->builder->report, 1, "points");
        return true;
    }
    if (type == GEOS_LINESTRING || type == GEOS_LINEARRING)
        return add_line(reader, geometry);
    if (type == GEOS_POLYGON) {
        if (!check_area(reader, geometry))
            return false;
        reader->areas = memory_reserve(reader->areas, &reader->capacity, reader->count + 1, sizeof(*reader->areas));
        reader->areas[reader->count++] = GEOSGeom_clone_r(reader->geos, geometry);
        reader->points += (size_t)GEOSGetNumCoordinates_r(reader->geos, geometry);
        return reader->points <= HOUSE_BUILDER_POINTS ||
               house_builder_fail(reader->builder, "areas of more than %d points, must be fewer", HOUSE_BUILDER_POINTS);
    }
    bool good = true;
    for (int i = 0; good && i < GEOSGetNumGeometries_r(reader->geos, geometry); i++)
        good = sort_out(reader, GEOSGetGeometryN_r(reader->geos, geometry, i));
    return good;
}

/* Uniting --------------------------------------------------------------------------------------------------------- */

typedef struct Sides {
    Broadphase *tree;
    size_t count, met;
} Sides;

static bool visit_side(void *context, int item) {
    (void)item;
    Sides *sides = context;
    return ++sides->met <= MOST_MEETINGS;
}

/* Counts the overlaps of a ring's sides with those of earlier rings, then adds its sides. */
static void meet_ring(const Reader *reader, Sides *sides, const GEOSGeometry *ring) {
    const GEOSCoordSequence *sequence = GEOSGeom_getCoordSeq_r(reader->geos, ring);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(reader->geos, sequence, &count);
    Vec2 before = {0, 0}, here;
    for (unsigned i = 0; i < count && sides->met <= MOST_MEETINGS; i++, before = here) {
        GEOSCoordSeq_getXY_r(reader->geos, sequence, i, &here.x, &here.y);
        if (i == 0)
            continue;
        Box box = box_include(box_include(box_empty(), before), here);
        broadphase_visit(sides->tree, box, visit_side, sides);
        broadphase_insert(sides->tree, box, (int)sides->count++);
    }
}

/* True if uniting the areas takes bounded time. */
static bool few_meet(const Reader *reader) {
    Sides sides = {.tree = broadphase_create()};
    for (size_t a = 0; a < reader->count; a++) {
        meet_ring(reader, &sides, GEOSGetExteriorRing_r(reader->geos, reader->areas[a]));
        for (int i = 0; i < GEOSGetNumInteriorRings_r(reader->geos, reader->areas[a]); i++)
            meet_ring(reader, &sides, GEOSGetInteriorRingN_r(reader->geos, reader->areas[a], i));
    }
    broadphase_destroy(sides.tree);
    return sides.met <= MOST_MEETINGS;
}

/* Notes when areas lie on top of each other, as in a file that holds its plan twice. */
static void note_overlap(const Reader *reader, const GEOSGeometry *all, const GEOSGeometry *united) {
    double sum = 0, area = 0, square = reader->unit * reader->unit;
    if (GEOSArea_r(reader->geos, all, &sum) && GEOSArea_r(reader->geos, united, &area) && sum > (1 + REPEATED) * area)
        import_report_note(reader->builder->report,
                           "the areas overlap: they have %.4g m2 together and cover %.4g m2, which counts once",
                           sum * square, area * square);
}

/* Unites areas that overlap or adjoin, so that no wall stands where they meet. */
static bool add_united(Reader *reader) {
    if (reader->points > MOST_UNITED || !few_meet(reader))
        return house_builder_fail(reader->builder, "the areas meet in too many places to be united");
    GEOSGeometry *all =
        GEOSGeom_createCollection_r(reader->geos, GEOS_GEOMETRYCOLLECTION, reader->areas, (unsigned)reader->count);
    reader->count = 0; /* the collection owns them now */
    /* turned areas that adjoin lie a rounding error apart */
    GEOSGeometry *met =
        all && reader->points <= MOST_MET ? GEOSSnap_r(reader->geos, all, all, ADJOINING / reader->unit) : NULL;
    GEOSGeometry *united = all ? GEOSUnaryUnion_r(reader->geos, met ? met : all) : NULL;
    GEOSGeom_destroy_r(reader->geos, met);
    bool good = united || fail(reader, "the areas cannot be united");
    if (good)
        note_overlap(reader, all, united);
    for (int i = 0; good && i < GEOSGetNumGeometries_r(reader->geos, united); i++)
        good = add_area(reader, GEOSGetGeometryN_r(reader->geos, united, i));
    GEOSGeom_destroy_r(reader->geos, united);
    GEOSGeom_destroy_r(reader->geos, all);
    return good;
}

/* Text ------------------------------------------------------------------------------------------------------------ */

/* Returns the end of the geometry that begins at `at`: after its closing bracket or the word EMPTY. NULL: there is
 * none, or the nesting is too deep. */
static char *find_end(HouseBuilder *builder, char *at) {
    int depth = 0;
    for (char *c = at; *c; c++) {
        depth += *c == '(' ? 1 : *c == ')' ? -1 : 0;
        if (depth > DEEPEST) {
            house_builder_fail(builder, "nested too deeply, must be at most %d brackets deep", DEEPEST);
            return NULL;
        }
        if (*c == ')' && depth <= 0)
            return c + 1;
        if (depth == 0 && strncasecmp(c, "EMPTY", strlen("EMPTY")) == 0)
            return c + strlen("EMPTY");
    }
    house_builder_fail(builder, "%s",
                       *at && depth > 0 ? "a bracket is not closed"
                                        : "the text is not WKT, must be like POLYGON ((0 0, 4 0, 4 3, 0 0))");
    return NULL;
}

static char *skip_space(HouseBuilder *builder, char *at) {
    for (; isspace((unsigned char)*at) || *at == ';'; at++)
        builder->line += *at == '\n';
    return at;
}

static bool read_one(Reader *reader, char *at, char *end) {
    char after = *end;
    *end = 0;
    if (strncasecmp(at, "SRID=", 5) == 0 && strchr(at, ';')) /* the reference system is that of metres */
        at = strchr(at, ';') + 1;
    reader->message[0] = 0;
    GEOSGeometry *geometry = GEOSWKTReader_read_r(reader->geos, reader->wkt, at);
    bool good = geometry ? sort_out(reader, geometry) : fail(reader, "no WKT");
    GEOSGeom_destroy_r(reader->geos, geometry);
    *end = after;
    return good;
}

static bool read_text(Reader *reader, char *text) {
    HouseBuilder *builder = reader->builder;
    char *at = skip_space(builder, text);
    if (!*at)
        return house_builder_fail(builder,
                                  "the file is empty, must contain WKT such as POLYGON ((0 0, 4 0, 4 3, 0 0))");
    while (*at) {
        char *end = find_end(builder, at);
        if (!end || !read_one(reader, at, end))
            return false;
        for (; at < end; at++)
            builder->line += *at == '\n';
        at = skip_space(builder, at);
    }
    builder->line = 1;
    return reader->count > 1 ? add_united(reader) : reader->count == 0 || add_area(reader, reader->areas[0]);
}

/* Size ------------------------------------------------------------------------------------------------------------ */

static bool begins(const char *text, const char *word) {
    return strncasecmp(text, word, strlen(word)) == 0;
}

/* Returns the extent of the first two numbers of each corner; single points are not part of the plan. */
static Box box_of_text(const char *text) {
    Box box = box_empty();
    bool points = false;
    for (const char *c = text; *c; c++) {
        if (begins(c, "POINT") || begins(c, "MULTIPOINT"))
            points = true;
        else if (begins(c, "POLYGON") || begins(c, "LINESTRING") || begins(c, "LINEARRING"))
            points = false;
        if (points || (*c != '(' && *c != ','))
            continue;
        char *next, *end;
        double x = strtod(c + 1, &next), y = strtod(next, &end);
        if (next > c + 1 && end > next && isfinite(x) && isfinite(y))
            box = box_include(box, vec2(x, y));
    }
    return box;
}

/* Refuses the reference system of degrees. */
static bool check_reference(HouseBuilder *builder, const char *text) {
    return !strcasestr(text, "SRID=4326;") ||
           house_builder_fail(builder, "the coordinates are degrees (SRID 4326): project them to metres");
}

/* Refuses coordinates that are degrees, and sizes in which metres are implausible. */
static bool check_size(HouseBuilder *builder, const char *text) {
    Box box = box_of_text(text);
    Vec2 size = vec2_sub(box.high, box.low);
    double longer = fmax(size.x, size.y);
    bool on_globe =
        fabs(box.low.x) <= 180 && fabs(box.high.x) <= 180 && fabs(box.low.y) <= 90 && fabs(box.high.y) <= 90;
    if (!(longer > 0))
        return true;
    if (on_globe && longer < DEGREES)
        return house_builder_fail(builder,
                                  "the coordinates look like degrees, %.6g of longitude by %.6g of latitude: project "
                                  "them to metres",
                                  size.x, size.y);
    if (plan_size_is_plausible(longer) || longer > FARTHEST) /* a point that is too far away is an error of its own */
        return true;
    bool possible[PLAN_SIZE_UNITS];
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        possible[u] = plan_size_units[u].metres == 1 || plan_size_is_plausible(longer * plan_size_units[u].metres);
    return plan_size_refuse(builder,
                            on_globe && longer < 1 ? "the coordinates are implausible as metres and may be degrees"
                                                   : "the coordinates are implausible as metres",
                            size, possible);
}

bool wkt_read(HouseBuilder *builder) {
    size_t size;
    char *text = text_read_file(builder->path, LARGEST_FILE, &size);
    if (!text)
        return house_builder_fail(builder, "cannot be read: %s", text_read_reason(errno));
    if (memchr(text, 0, size)) {
        memory_free(text);
        return house_builder_fail(builder, "the file contains a zero byte, must be text");
    }
    Reader reader = {.builder = builder, .geos = GEOS_init_r(), .unit = 1};
    if (builder->options->unit > 0)
        reader.unit = builder->options->unit;
    GEOSContext_setErrorMessageHandler_r(reader.geos, remember_message, &reader);
    reader.wkt = GEOSWKTReader_create_r(reader.geos);
    char *begin = text + (strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0); /* a byte order mark */
    bool good = check_reference(builder, begin) && (builder->options->unit > 0 || check_size(builder, begin)) &&
                read_text(&reader, begin);
    for (size_t a = 0; a < reader.count; a++)
        GEOSGeom_destroy_r(reader.geos, reader.areas[a]);
    memory_free(reader.areas);
    GEOSWKTReader_destroy_r(reader.geos, reader.wkt);
    GEOS_finish_r(reader.geos);
    memory_free(text);
    return good;
}
