/* Reads the record as other programs do. */

#include "exchange/jupedsim.h"

#include <sqlite3.h>
#include <unistd.h>

#define GEOS_USE_ONLY_R_API
#include <geos_c.h>

#include "case.h"
#include "check.h"

static double number(sqlite3 *database, const char *query) {
    sqlite3_stmt *statement = NULL;
    double value = NAN;
    if (sqlite3_prepare_v2(database, query, -1, &statement, NULL) == SQLITE_OK && sqlite3_step(statement) == SQLITE_ROW)
        value = sqlite3_column_double(statement, 0);
    sqlite3_finalize(statement);
    return value;
}

TEST(the_record_is_jupedsims_version_2_with_heading) {
    char path[CHECK_PATH];
    check_temporary(path, "record-XXXXXX");
    close(mkstemp(path));
    House house;
    case_house(&house, "two-chairs-corridor", -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(jupedsim_write(&house, &observation, path) == 0);
    sqlite3 *database = NULL;
    CHECK(sqlite3_open(path, &database) == SQLITE_OK);
    CHECK(number(database, "SELECT value FROM metadata WHERE key = 'version'") == 2);
    CHECK_NEAR(number(database, "SELECT value FROM metadata WHERE key = 'fps'"), 25, 1e-9);
    CHECK(number(database, "SELECT count(DISTINCT id) FROM trajectory_data") == 2);
    CHECK(number(database,
                 "SELECT count(*) FROM (SELECT 1 FROM trajectory_data GROUP BY frame, id HAVING count(*) > 1)") == 0);
    CHECK_NEAR(number(database, "SELECT max(abs(ori_x * ori_x + ori_y * ori_y - 1)) FROM trajectory_data"), 0, 1e-12);
    CHECK_NEAR(number(database, "SELECT pos_x FROM trajectory_data WHERE frame = 0 AND id = 1"), house.people[0].at.x,
               1e-12);
    CHECK(number(database, "SELECT count(*) FROM frame_data WHERE geometry_hash NOT IN (SELECT hash FROM geometry)") ==
          0);
    CHECK(number(database, "SELECT max(frame) FROM frame_data") ==
          number(database, "SELECT max(frame) FROM trajectory_data"));
    sqlite3_close(database);
    unlink(path);
    observation_free(&observation);
    house_free(&house);
}

/* All people walk in the walkable area, which excludes the walls. */
TEST(the_geometry_is_where_people_are) {
    char path[CHECK_PATH];
    check_temporary(path, "record-XXXXXX");
    close(mkstemp(path));
    House house;
    case_house(&house, "ube-techno-house", -1, NULL);
    Observation observation = case_run(&house, 2);
    CHECK(jupedsim_write(&house, &observation, path) == 0);
    sqlite3 *database = NULL;
    sqlite3_stmt *statement = NULL;
    sqlite3_open(path, &database);
    sqlite3_prepare_v2(database, "SELECT wkt FROM geometry", -1, &statement, NULL);
    CHECK(sqlite3_step(statement) == SQLITE_ROW);
    GEOSContextHandle_t geos = GEOS_init_r();
    GEOSWKTReader *reader = GEOSWKTReader_create_r(geos);
    GEOSGeometry *area = GEOSWKTReader_read_r(geos, reader, (const char *)sqlite3_column_text(statement, 0));
    CHECK(area && GEOSGeomTypeId_r(geos, area) == GEOS_POLYGON && GEOSisValid_r(geos, area) == 1);
    sqlite3_finalize(statement);
    int outside = 0;
    sqlite3_prepare_v2(database, "SELECT pos_x, pos_y FROM trajectory_data", -1, &statement, NULL);
    while (sqlite3_step(statement) == SQLITE_ROW) {
        GEOSGeometry *point = GEOSGeom_createPointFromXY_r(geos, sqlite3_column_double(statement, 0),
                                                           sqlite3_column_double(statement, 1));
        outside += GEOSContains_r(geos, area, point) != 1;
        GEOSGeom_destroy_r(geos, point);
    }
    CHECK(outside == 0);
    sqlite3_finalize(statement);
    sqlite3_close(database);
    unlink(path);
    GEOSGeom_destroy_r(geos, area);
    GEOSWKTReader_destroy_r(geos, reader);
    GEOS_finish_r(geos);
    observation_free(&observation);
    house_free(&house);
}

TEST(a_record_that_cannot_be_written_says_so) {
    House house;
    case_house(&house, "straight-corridor", -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(jupedsim_write(&house, &observation, "/nowhere/at/all.sqlite") != 0);
    observation_free(&observation);
    house_free(&house);
}
