#include "exchange/jupedsim.h"

#include <errno.h>
#define GEOS_USE_ONLY_R_API
#include <geos_c.h>
#include <sqlite3.h>
#include <stdint.h>
#include <stdio.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "base/text.h"

static const char tables[] =
    "CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL, pos_y REAL NOT "
    "NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL);"
    "CREATE TABLE metadata (key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE geometry (hash INTEGER NOT NULL, wkt TEXT NOT NULL);"
    "CREATE UNIQUE INDEX geometry_hash on geometry (hash);"
    "CREATE TABLE frame_data (frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);"
    "CREATE INDEX frame_id_idx ON trajectory_data (frame, id);";

enum { GEOMETRY_HASH = 1 /* the house does not change during a run */ };

/* Walkable area: the plan's box less the solids -------------------------------------------------------------------- */

static GEOSGeometry *ring_polygon(GEOSContextHandle_t geos, const Vec2 *points, size_t count) {
    GEOSCoordSequence *sequence = GEOSCoordSeq_create_r(geos, (unsigned)count + 1, 2);
    for (size_t i = 0; i <= count; i++)
        GEOSCoordSeq_setXY_r(geos, sequence, (unsigned)i, points[i % count].x, points[i % count].y);
    return GEOSGeom_createPolygon_r(geos, GEOSGeom_createLinearRing_r(geos, sequence), NULL, 0);
}

static double ring_area(const Vec2 *points, size_t count) {
    double area = 0;
    for (size_t i = 0; i < count; i++)
        area += vec2_cross(vec2_sub(points[i], points[0]), vec2_sub(points[(i + 1) % count], points[0])) / 2;
    return area;
}

/* Subtracts a solid's outer ring; a hole in a solid is free space again. */
static GEOSGeometry *walkable(GEOSContextHandle_t geos, const Outline *outline) {
    Box box = box_expand(outline->box, FREESPACE_MARGIN);
    Vec2 corners[4] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    GEOSGeometry *area = ring_polygon(geos, corners, 4);
    for (size_t r = 0; r < outline->rings.count && area; r++) {
        const Vec2 *points = outline->rings.points + outline->rings.starts[r];
        size_t count = outline->rings.starts[r + 1] - outline->rings.starts[r];
        GEOSGeometry *ring = ring_polygon(geos, points, count);
        GEOSGeometry *next =
            ring_area(points, count) > 0 ? GEOSDifference_r(geos, area, ring) : GEOSUnion_r(geos, area, ring);
        GEOSGeom_destroy_r(geos, ring);
        GEOSGeom_destroy_r(geos, area);
        area = next;
    }
    return area;
}

/* Returns the part in which the first person stands, since PedPy takes a single polygon. */
static const GEOSGeometry *inhabited_part(GEOSContextHandle_t geos, const GEOSGeometry *area, const House *house) {
    int parts = GEOSGetNumGeometries_r(geos, area);
    const GEOSGeometry *found = GEOSGetGeometryN_r(geos, area, 0);
    if (!house->person_count)
        return found;
    GEOSGeometry *person = GEOSGeom_createPointFromXY_r(geos, house->people[0].at.x, house->people[0].at.y);
    for (int i = 0; i < parts; i++)
        if (GEOSContains_r(geos, GEOSGetGeometryN_r(geos, area, i), person) == 1)
            found = GEOSGetGeometryN_r(geos, area, i);
    GEOSGeom_destroy_r(geos, person);
    return found;
}

/* Returns new text, or NULL. The caller releases it with memory_free. */
static char *walkable_wkt(const House *house) {
    GEOSContextHandle_t geos = GEOS_init_r();
    GEOSGeometry *area = walkable(geos, &house->outline);
    char *copy = NULL;
    if (area) {
        GEOSWKTWriter *writer = GEOSWKTWriter_create_r(geos);
        GEOSWKTWriter_setTrim_r(geos, writer, 1);
        GEOSWKTWriter_setRoundingPrecision_r(geos, writer, 6);
        char *text = GEOSWKTWriter_write_r(geos, writer, inhabited_part(geos, area, house));
        if (text)
            copy = text_copy(text);
        GEOSFree_r(geos, text);
        GEOSWKTWriter_destroy_r(geos, writer);
        GEOSGeom_destroy_r(geos, area);
    }
    GEOS_finish_r(geos);
    return copy;
}

/* Rows --------------------------------------------------------------------------------------------------------------*/

static int64_t frame_of(const Observation *observation, const double *row) {
    return (int64_t)(row[TRACE_TIME] / observation->sample + 0.5);
}

static bool step_and_reset(sqlite3_stmt *statement) {
    bool good = sqlite3_step(statement) == SQLITE_DONE;
    return sqlite3_reset(statement) == SQLITE_OK && good;
}

/* Writes one row per frame and person: the last row of a person, at the exit, may fall into the frame of the row
 * before. */
static bool write_trajectories(sqlite3 *database, const House *house, const Observation *observation,
                               int64_t *last_frame) {
    const Trace *trace = &observation->trace;
    sqlite3_stmt *insert = NULL;
    if (sqlite3_prepare_v2(database, "INSERT INTO trajectory_data VALUES (?, ?, ?, ?, ?, ?)", -1, &insert, NULL))
        return false;
    int64_t *written = memory_zeroed(house->person_count, sizeof *written);
    bool good = true;
    for (size_t i = 0; i < house->person_count; i++)
        written[i] = -1;
    for (size_t r = 0; r < trace->rows && good; r++) {
        const double *row = trace_row(trace, r);
        int64_t frame = frame_of(observation, row), id = (int64_t)row[TRACE_PERSON];
        if (frame <= written[id])
            continue;
        written[id] = frame;
        *last_frame = frame > *last_frame ? frame : *last_frame;
        Vec2 heading = vec2_heading(row[TRACE_HEADING]);
        sqlite3_bind_int64(insert, 1, frame);
        sqlite3_bind_int64(insert, 2, id + 1);
        sqlite3_bind_double(insert, 3, row[TRACE_X]);
        sqlite3_bind_double(insert, 4, row[TRACE_Y]);
        sqlite3_bind_double(insert, 5, heading.x);
        sqlite3_bind_double(insert, 6, heading.y);
        good = step_and_reset(insert);
    }
    memory_free(written);
    return sqlite3_finalize(insert) == SQLITE_OK && good;
}

static bool write_metadata(sqlite3 *database, const House *house, const Observation *observation) {
    sqlite3_stmt *insert = NULL;
    if (sqlite3_prepare_v2(database, "INSERT INTO metadata VALUES (?, ?)", -1, &insert, NULL))
        return false;
    Box box = box_expand(house->outline.box, FREESPACE_MARGIN);
    const struct {
        const char *key;
        double value;
    } rows[] = {{"version", 2},      {"fps", 1 / observation->sample},
                {"xmin", box.low.x}, {"xmax", box.high.x},
                {"ymin", box.low.y}, {"ymax", box.high.y}};
    bool good = true;
    for (size_t i = 0; i < sizeof rows / sizeof *rows && good; i++) {
        char value[32];
        snprintf(value, sizeof value, "%.9g", rows[i].value);
        sqlite3_bind_text(insert, 1, rows[i].key, -1, SQLITE_STATIC);
        sqlite3_bind_text(insert, 2, value, -1, SQLITE_TRANSIENT);
        good = step_and_reset(insert);
    }
    return sqlite3_finalize(insert) == SQLITE_OK && good;
}

static bool write_geometry(sqlite3 *database, const House *house, int64_t last_frame) {
    sqlite3_stmt *insert = NULL;
    char *wkt = walkable_wkt(house);
    bool good =
        wkt && sqlite3_prepare_v2(database, "INSERT INTO geometry VALUES (?, ?)", -1, &insert, NULL) == SQLITE_OK;
    if (good) {
        sqlite3_bind_int64(insert, 1, GEOMETRY_HASH);
        sqlite3_bind_text(insert, 2, wkt, -1, SQLITE_STATIC);
        good = step_and_reset(insert);
    }
    sqlite3_finalize(insert);
    memory_free(wkt);
    if (!good || sqlite3_prepare_v2(database, "INSERT INTO frame_data VALUES (?, ?)", -1, &insert, NULL))
        return false;
    for (int64_t frame = 0; frame <= last_frame && good; frame++) {
        sqlite3_bind_int64(insert, 1, frame);
        sqlite3_bind_int64(insert, 2, GEOMETRY_HASH);
        good = step_and_reset(insert);
    }
    return sqlite3_finalize(insert) == SQLITE_OK && good;
}

int jupedsim_write(const House *house, const Observation *observation, const char *path) {
    sqlite3 *database = NULL;
    int64_t last_frame = 0;
    int error;
    FileWrite *file = file_write_begin_named(path, "", &error);
    if (!file)
        return error;
    bool good =
        sqlite3_open(file_write_part(file), &database) == SQLITE_OK &&
        sqlite3_exec(database, "PRAGMA journal_mode = OFF; BEGIN", NULL, NULL, NULL) == SQLITE_OK &&
        sqlite3_exec(database, tables, NULL, NULL, NULL) == SQLITE_OK && write_metadata(database, house, observation) &&
        write_trajectories(database, house, observation, &last_frame) && write_geometry(database, house, last_frame) &&
        sqlite3_exec(database, "COMMIT", NULL, NULL, NULL) == SQLITE_OK;
    if (!good)
        error = database && sqlite3_system_errno(database) ? sqlite3_system_errno(database) : EIO;
    if (sqlite3_close(database) != SQLITE_OK && !error)
        error = EIO;
    return file_write_end(file, error);
}
