#include "check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exchange/walkable.h"
#include "imported.h"
#include "scratch.h"

TEST(areas_side_by_side_are_one_and_holes_are_obstacles) {
    Imported import =
        imported_text(".wkt",
                      "GEOMETRYCOLLECTION (POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0), (2 2, 3 2, 3 3, 2 3, 2 2)),\n"
                      "  POLYGON ((8 1, 10 1, 10 3, 8 3, 8 1)), POINT (1 1))\nLINESTRING (1 4, 2 4)\n",
                      (ImportOptions){0});
    imported_check_lists(&import.plan,
                         "  'walls': [\n"
                         "    {'id': 'w1', 'points': [[1, 4], [2, 4]], 'thickness': 0},\n"
                         "    {'id': 'w2', 'points': [[10, 3], [10, 1], [8, 1], [8, 0], [0, 0], [0, 6], [8, 6], [8, "
                         "3], [10, 3]], 'thickness': 0},\n"
                         "    {'id': 'w3', 'points': [[3, 2], [3, 3], [2, 3], [2, 2], [3, 2]], 'thickness': 0}\n"
                         "  ]\n}\n");
    CHECK(imported_left_out(&import, "points", 1));
    imported_end(&import, true);
}

TEST(a_byte_order_mark_is_skipped) {
    Imported import = imported_text(".wkt", "\xef\xbb\xbfPOLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))", (ImportOptions){0});
    CHECK(import.plan.wall_count == 1);
    imported_end(&import, true);
}

TEST(a_unit_that_is_given_makes_millimetres_a_house) {
    Imported import = imported_text(".wkt", "POLYGON ((0 0, 8000 0, 8000 6000, 0 6000, 0 0))",
                                    (ImportOptions){.unit = import_unit("mm")});
    CHECK(import.good && import.plan.walls[0].points.at[2].y == 6);
    imported_end(&import, true);
}

static void check_refused(const char *text, const char *says) {
    Imported import = imported_text(".wkt", text, (ImportOptions){0});
    CHECK(import.fault.count == 1 && strstr(import.fault.lines[0], says));
    imported_end(&import, false);
}

TEST(degrees_and_areas_too_small_for_a_plan_are_refused) {
    check_refused("SRID=4326;POLYGON ((13.1 52.1, 13.4 52.1, 13.4 52.4, 13.1 52.1))",
                  "the coordinates are degrees (SRID 4326): project them to metres");
    check_refused("POLYGON ((13.37 52.51, 13.385 52.51, 13.385 52.52, 13.37 52.51))",
                  "implausible as metres and may be degrees");
    check_refused("POLYGON ((0 0, 1.2 0, 1.2 0.6, 0 0.6, 0 0))",
                  "the coordinates are implausible as metres: the plan would be 1.2 m by 0.6 m in m");
    Imported import =
        imported_text(".wkt", "SRID=25833;POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0)) POINT (9000 0)", (ImportOptions){0});
    CHECK(import.plan.wall_count == 1 && imported_left_out(&import, "points", 1));
    imported_end(&import, true);
}

TEST(areas_on_top_of_each_other_count_once_and_are_noted) {
    Imported import = imported_text(".wkt", "POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0))\nPOLYGON ((0 0, 8 0, 8 6, 0 6, 0 0))",
                                    (ImportOptions){0});
    CHECK(import.plan.wall_count == 1);
    CHECK(imported_noted(&import, "the areas overlap: they have 96 m2 together and cover 48 m2, which counts once"));
    imported_end(&import, true);
    import = imported_text(".wkt", "POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0))\nPOLYGON ((8 0, 9 0, 9 6, 8 6, 8 0))",
                           (ImportOptions){0});
    CHECK(!imported_noted(&import, "the areas overlap"));
    imported_end(&import, true);
}

/* Returns twice the area of the rings of a POLYGON, outer minus inner ones. */
static double area_of(const char *wkt) {
    double area = 0, ring = 0, x, y, last_x = 0, last_y = 0;
    bool first = true, outer = true;
    for (const char *c = strstr(wkt, "(("); c && *c; c++) {
        int used = 0;
        if (*c == '(' || *c == ')') {
            area += outer ? fabs(ring) : -fabs(ring);
            outer &= ring == 0;
            ring = 0;
            first = true;
        } else if (sscanf(c, "%lf %lf%n", &x, &y, &used) == 2 && used) {
            ring += first ? 0 : last_x * y - x * last_y;
            last_x = x;
            last_y = y;
            first = false;
            c += used - 1;
        }
    }
    return area;
}

/* Exports a house file, imports that, exports it again. */
static void check_round_trip(const char *file) {
    Plan plan = {0};
    Fault fault = {0};
    CHECK(plan_read(&plan, scratch_source(file), NULL, 0, &fault));
    char *once = walkable_wkt(&plan, &fault);
    CHECK(once && strncmp(once, "POLYGON ((", 10) == 0);
    Imported import = imported_text(".wkt", once ? once : "", (ImportOptions){0});
    char *twice = walkable_wkt(&import.plan, &fault);
    CHECK(twice);
    if (once && twice)
        CHECK_NEAR(area_of(twice), area_of(once), 1e-6);
    imported_end(&import, true);
    memory_free(once);
    memory_free(twice);
    plan_free(&plan);
    CHECK(!fault.total);
    fault_clear(&fault);
}

TEST(an_exported_area_keeps_its_size_when_it_is_imported_and_exported_again) {
    check_round_trip("houses/ube-techno-house.json");
    check_round_trip("houses/corner-0.90-0.90.json");
    check_round_trip("houses/flat-0.910-module.json");
}

static void check_area(const char *members, const char *expected) {
    Plan plan;
    Fault fault = {0};
    scratch_plan(&plan, members);
    char *wkt = walkable_wkt(&plan, &fault);
    CHECK_TEXT(wkt ? wkt : fault.lines[0], expected);
    memory_free(wkt);
    fault_clear(&fault);
    plan_free(&plan);
}

TEST(the_walkable_area_is_what_is_inside_less_what_stands_there) {
    check_area("'walls': [{'id': 'w', 'points': [[0,0],[4,0],[4,3],[0,3],[0,0]], 'thickness': 0.2}], 'furniture': "
               "[{'id': 'f', 'centre': [2,2], 'size': [1,0.5]}]",
               "POLYGON ((0.1 0.1, 0.1 2.9, 3.9 2.9, 3.9 0.1, 0.1 0.1), (1.5 1.75, 2.5 1.75, 2.5 2.25, 1.5 2.25, 1.5 "
               "1.75))\n");
}

TEST(a_locked_door_keeps_the_outside_out_and_an_open_one_lets_it_in) {
    static const char walls[] = "'walls': [{'id': 'w', 'points': [[0,0],[4,0],[4,3],[0,3],[0,0]], 'thickness': 0}]";
    char members[300];
    snprintf(members, sizeof members, "%s, 'doors': [{'id': 'd', 'wall': 'w', 'at': 2, 'width': 1, 'state': 'locked'}]",
             walls);
    check_area(members, "POLYGON ((0 0, 0 3, 4 3, 4 0, 0 0))\n");
    snprintf(members, sizeof members, "%s, 'doors': [{'id': 'd', 'wall': 'w', 'at': 2, 'width': 1}]", walls);
    check_area(members, "POLYGON ((-1 -1, -1 4, 5 4, 5 -1, -1 -1), (-0.0005 -0.0005, 1.5 -0.0005, 1.5 0.0005, 0.0005 "
                        "0.0005, 0.0005 2.9995, 3.9995 2.9995, 3.9995 0.0005, 2.5 0.0005, 2.5 -0.0005, 4.0005 -0.0005, "
                        "4.0005 3.0005, -0.0005 3.0005, -0.0005 -0.0005))\n");
}
