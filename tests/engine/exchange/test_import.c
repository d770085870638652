#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <zip.h>

#include "base/text.h"
#include "check.h"
#include "scratch.h"
#include "exchange/import.h"
#include "exchange/walkable.h"

enum { PATH_SIZE = 80 };

/* Returns a new file name below /tmp with that ending; no such file exists. */
static const char *new_path(char path[PATH_SIZE], const char *ending) {
    char base[SCRATCH_PATH];
    scratch_write(base, "");
    unlink(base);
    snprintf(path, PATH_SIZE, "%s%s", base, ending);
    return path;
}

static void write_text(const char *path, const char *text) {
    CHECK(text_write_quickly(path, text, strlen(text)) == 0);
}

/* Writes a zip file with one text. */
static void write_zip(const char *path, const char *name, const char *text) {
    int error = 0;
    zip_t *zip = zip_open(path, ZIP_CREATE | ZIP_EXCL, &error);
    CHECK(zip);
    zip_source_t *source = zip_source_buffer(zip, text, strlen(text), 0);
    CHECK(zip_file_add(zip, name, source, 0) >= 0);
    CHECK(zip_close(zip) == 0);
}

typedef struct Import {
    Plan plan;
    ImportReport report;
    Fault fault;
    bool good;
} Import;

static Import import_file(const char *path, ImportOptions options) {
    Import import = {.good = false};
    import.good = import_read(&import.plan, path, &options, &import.report, &import.fault);
    CHECK(import.good == (import.fault.total == 0));
    unlink(path);
    return import;
}

/* Prints an error only if it was not expected. */
static void end(Import *import, bool wanted) {
    CHECK(import->good == wanted);
    for (size_t i = 0; i < import->fault.count && wanted; i++)
        printf("%s\n", import->fault.lines[i]);
    fault_clear(&import->fault);
    import_report_clear(&import->report);
    plan_free(&import->plan);
}

static Import import_text(const char *ending, const char *text, ImportOptions options) {
    char path[PATH_SIZE];
    write_text(new_path(path, ending), text);
    return import_file(path, options);
}

static Import import_home(const char *elements, ImportOptions options) {
    char path[PATH_SIZE];
    Text xml = {0};
    text_format(&xml, "<?xml version='1.0'?>\n<home version='7200' name='/somewhere/else.sh3d'>\n%s\n</home>",
                elements);
    write_zip(new_path(path, ".sh3d"), "Home.xml", xml.text);
    memory_free(xml.text);
    return import_file(path, options);
}

/* Returns the lists of the house file from "walls" on, since names and notes contain the file's name. */
static void check_lists(const Plan *plan, const char *expected) {
    char *text = plan_text(plan), *walls = strstr(text, "  \"walls\"");
    for (char *c = text; *c; c++)
        *c = *c == '"' ? '\'' : *c;
    CHECK(walls);
    if (walls)
        CHECK_TEXT(walls, expected);
    memory_free(text);
}

static bool is_left(const Import *import, const char *what, size_t count) {
    for (size_t i = 0; i < import->report.left_out_count; i++)
        if (strcmp(import->report.left_out[i].what, what) == 0)
            return import->report.left_out[i].count == count;
    return false;
}

static bool is_noted(const Import *import, const char *part) {
    for (size_t i = 0; i < import->report.note_count; i++)
        if (strstr(import->report.notes[i], part))
            return true;
    return false;
}

/* Sweet Home 3D --------------------------------------------------------------------------------------------------- */

static const char box_walls[] =
    "<wall id='a' wallAtEnd='b' xStart='0' yStart='0' xEnd='600' yEnd='0' height='250' thickness='10'/>"
    "<wall id='b' xStart='600' yStart='0' xEnd='600' yEnd='400' height='250' thickness='10'/>"
    "<wall id='c' xStart='600' yStart='400' xEnd='0' yEnd='400' height='250' thickness='10'/>"
    "<wall id='d' xStart='0' yStart='400' xEnd='0' yEnd='0' height='250' thickness='10'/>"
    "<wall id='m' xStart='400' yStart='0' xEnd='400' yEnd='400' height='240' thickness='7.5'/>";

static Import import_box(const char *elements, ImportOptions options) {
    Text all = {0};
    text_format(&all, "%s%s", box_walls, elements);
    Import import = import_home(all.text, options);
    memory_free(all.text);
    return import;
}

TEST(walls_that_meet_end_to_end_are_one_and_centimetres_down_the_screen_become_metres_up) {
    Import import = import_box("", (ImportOptions){0});
    check_lists(&import.plan, "  'walls': [\n"
                              "    {'id': 'w1', 'points': [[0, 0], [6, 0], [6, -4], [0, -4], [0, 0]], 'thickness': "
                              "0.1, 'height': 2.5},\n"
                              "    {'id': 'w2', 'points': [[4, 0], [4, -4]], 'thickness': 0.075}\n"
                              "  ]\n}\n");
    CHECK(is_noted(&import, "the house has no exit yet"));
    CHECK(strstr(import.plan.note, ".sh3d (Sweet Home 3D)"));
    end(&import, true);
}

TEST(a_door_is_as_wide_as_its_sashes_and_hangs_and_swings_as_drawn) {
    Import import = import_box(
        "<doorOrWindow catalogId='eTeks#door' name='Door' x='400' y='200' width='91.5' depth='12' height='208' "
        "angle='1.5707963267948966'><sash xAxis='0.0546448087' yAxis='0.5' width='0.890710382514' startAngle='0' "
        "endAngle='-1.5707963'/></doorOrWindow>"
        "<doorOrWindow name='FastMarching' x='100' y='400' width='100' depth='12' height='208'><sash xAxis='0.95' "
        "yAxis='0.5' width='0.9' startAngle='3.14159265' endAngle='1.5707963'/></doorOrWindow>"
        "<doorOrWindow name='Mirrored' x='300' y='400' width='100' depth='12' height='208' modelMirrored='true'><sash "
        "xAxis='0.95' yAxis='0.5' width='0.9' startAngle='3.14159265' endAngle='1.5707963'/></doorOrWindow>",
        (ImportOptions){0});
    CHECK(import.plan.door_count == 3);
    if (import.plan.door_count == 3) {
        const Door *inner = &import.plan.doors[0], *front = &import.plan.doors[1], *mirrored = &import.plan.doors[2];
        CHECK_TEXT(inner->wall, "w2");
        CHECK_NEAR(inner->width, 0.815, 1e-9);
        CHECK_NEAR(inner->at, 2, 1e-6);
        CHECK(inner->kind == DOOR_HINGED && inner->hinge == HINGE_START && inner->swing == SWING_RIGHT);
        CHECK(front->wall_index == 0 && front->segment == 2);
        CHECK_NEAR(front->width, 0.9, 1e-9);
        CHECK_NEAR(front->at, 5, 1e-6); /* the wall runs from (6, -4) to (0, -4) */
        CHECK(front->hinge == HINGE_START && front->swing == SWING_RIGHT);
        CHECK(mirrored->hinge == HINGE_END && mirrored->swing == SWING_RIGHT);
    }
    end(&import, true);
}

TEST(windows_lamps_hidden_things_and_rugs_stand_in_nobody_s_way) {
    Import import = import_box(
        "<doorOrWindow catalogId='eTeks#window' name='Fenster' elevation='80' x='100' y='0' width='91' depth='12' "
        "height='120'/>"
        "<light name='Lamp' elevation='200' x='100' y='100' width='30' depth='30' height='20'/>"
        "<pieceOfFurniture name='Hidden' visible='false' x='100' y='100' width='30' depth='30' height='20'/>"
        "<pieceOfFurniture name='Rug' x='100' y='100' width='200' depth='150' height='1'/>"
        "<furnitureGroup x='0' y='0' width='1' depth='1' height='1'><pieceOfFurniture name='Caf&#233; table' x='150' "
        "y='100' width='120' depth='80' height='74' angle='0.7853981633974483'/></furnitureGroup>"
        "<label x='1' y='1'/><polyline><point x='1' y='2'/></polyline>",
        (ImportOptions){0});
    CHECK(import.plan.furniture_count == 1);
    if (import.plan.furniture_count) {
        const Furniture *table = &import.plan.furniture[0];
        CHECK_TEXT(table->name, "Caf\u00e9 table");
        CHECK_NEAR(table->centre.x, 1.5, 0);
        CHECK_NEAR(table->centre.y, -1, 0);
        CHECK_NEAR(table->size.x, 1.2, 0);
        CHECK_NEAR(table->angle, -45, 0);
        CHECK_NEAR(table->height, 0.74, 0);
    }
    CHECK(is_left(&import, "windows", 1) && is_left(&import, "pieces that hang above 1.8 m", 1));
    CHECK(is_left(&import, "pieces that are hidden", 1) && is_left(&import, "rugs and the like, up to 3 cm high", 1));
    CHECK(is_left(&import, "texts", 1) && is_left(&import, "drawn lines", 1));
    end(&import, true);
}

static const char storeys[] =
    "<level id='u' name='Upper' elevation='260'/><level id='g' name='Ground' elevation='0'/>"
    "<wall level='u' xStart='0' yStart='0' xEnd='500' yEnd='0' thickness='10'/>"
    "<wall level='g' xStart='0' yStart='0' xEnd='700' yEnd='0' thickness='10'/>"
    "<room level='g' name='Hall'><point x='0' y='0'/><point x='700' y='0'/><point x='700' y='100'/></room>";

TEST(one_storey_is_taken_the_lowest_or_the_one_that_is_named) {
    Import import = import_home(storeys, (ImportOptions){0});
    CHECK(import.plan.wall_count == 1 && import.plan.room_count == 1);
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 7);
    CHECK(is_noted(&import, "\"Ground\", is imported; choose another of \"Upper\", \"Ground\""));
    end(&import, true);
    import = import_home(storeys, (ImportOptions){.level = "Upper"});
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 5);
    CHECK(is_left(&import, "walls, rooms and furniture on other storeys", 2));
    end(&import, true);
    import = import_home(storeys, (ImportOptions){.level = "Cellar"});
    CHECK(import.fault.count &&
          strstr(import.fault.lines[0], "unknown storey \"Cellar\", the storeys are \"Upper\", \"Ground\""));
    end(&import, false);
}

TEST(a_round_wall_bulges_to_the_side_it_is_drawn_on) {
    Import import = import_home("<wall xStart='700' yStart='0' xEnd='700' yEnd='400' thickness='10' "
                                "arcExtent='3.141592653589793'/>",
                                (ImportOptions){0});
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t i = 0; import.good && i < import.plan.walls[0].points.count; i++) {
        Vec2 at = import.plan.walls[0].points.at[i];
        CHECK_NEAR(vec2_distance(at, vec2(7, -2)), 2, 1e-6);
        least = fmin(least, at.x);
        most = fmax(most, at.x);
    }
    CHECK_NEAR(least, 7, 1e-6);
    CHECK_NEAR(most, 9, 0.02);
    end(&import, true);
}

TEST(a_zip_that_unpacks_to_too_much_is_refused_before_it_does) {
    char path[PATH_SIZE];
    size_t size = 8 * 1024 * 1024;
    char *blank = memory_zeroed(size + 1, 1);
    memset(blank, ' ', size);
    memcpy(blank, "<home>", 6);
    write_zip(new_path(path, ".sh3d"), "Home.xml", blank);
    Import import = import_file(path, (ImportOptions){0});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "compressed more than 200 times"));
    end(&import, false);
    memory_free(blank);
}

/* Drawings -------------------------------------------------------------------------------------------------------- */

/* Turns groups of a drawing, "0 LINE 8 WALL 10 0 ...", into lines. */
static Import import_drawing(const char *header, const char *blocks, const char *entities, ImportOptions options) {
    Text text = {0};
    text_format(&text,
                "0 SECTION 2 HEADER %s 0 ENDSEC 0 SECTION 2 BLOCKS %s 0 ENDSEC 0 SECTION 2 ENTITIES %s 0 ENDSEC 0 EOF ",
                header, blocks, entities);
    for (char *c = text.text; *c; c++)
        *c = *c == ' ' ? '\n' : *c;
    for (char *from = text.text, *to = text.text;; from++) { /* blanks where a part is empty */
        if (!(*from == '\n' && (to == text.text || to[-1] == '\n')))
            *to++ = *from;
        if (!*from)
            break;
    }
    Import import = import_text(".dxf", text.text, options);
    memory_free(text.text);
    return import;
}

static const char millimetres[] = "9 $INSUNITS 70 4";
static const char room[] = "0 LWPOLYLINE 8 A-WALL 90 4 70 1 10 0 20 0 10 6000 20 0 10 6000 20 4000 10 0 20 4000 ";

TEST(lines_of_a_drawing_are_joined_into_walls) {
    Import import =
        import_drawing(millimetres, "",
                       "0 LINE 8 A-WALL 10 0 20 0 11 3000 21 0 0 LINE 8 A-WALL 10 6000 20 0 11 3000 21 0 "
                       "0 LINE 8 A-WALL 10 6000 20 0 11 6000 21 4000 0 LINE 8 A-WALL 10 0 20 0 11 3000 21 0 "
                       "0 POLYLINE 8 A-WALL 70 0 40 100 0 VERTEX 10 0 20 2000 0 VERTEX 10 2000 20 2000 0 SEQEND",
                       (ImportOptions){0});
    check_lists(&import.plan, "  'walls': [\n"
                              "    {'id': 'w1', 'points': [[0, 0], [6, 0], [6, 4]], 'thickness': 0},\n"
                              "    {'id': 'w2', 'points': [[0, 2], [2, 2]], 'thickness': 0.1}\n"
                              "  ]\n}\n");
    CHECK(is_noted(&import, "the unit is mm, as the file says: the plan is 6 m by 4 m"));
    CHECK(is_left(&import, "SEQEND", 1));
    end(&import, true);
}

TEST(a_slender_rectangle_is_a_wall_as_thick_as_it_is_and_a_stout_one_is_its_sides) {
    Import import =
        import_drawing(millimetres, "",
                       "0 LWPOLYLINE 8 WALL 90 4 70 1 10 0 20 0 10 4000 20 0 10 4000 20 200 10 0 20 200 "
                       "0 LWPOLYLINE 8 WALL 90 4 70 1 10 0 20 1000 10 400 20 1000 10 400 20 1300 10 0 20 1300",
                       (ImportOptions){0});
    check_lists(&import.plan,
                "  'walls': [\n"
                "    {'id': 'w1', 'points': [[0, 0.1], [4, 0.1]], 'thickness': 0.2},\n"
                "    {'id': 'w2', 'points': [[0, 1], [0.4, 1], [0.4, 1.3], [0, 1.3], [0, 1]], 'thickness': "
                "0}\n"
                "  ]\n}\n");
    end(&import, true);
}

TEST(a_bulge_is_an_arc_to_the_right_of_its_way_when_positive) {
    Import import = import_drawing(millimetres, "", "0 LWPOLYLINE 8 WALL 90 2 70 0 10 0 20 0 42 1 10 4000 20 0",
                                   (ImportOptions){0});
    double lowest = 0;
    for (size_t i = 0; import.good && i < import.plan.walls[0].points.count; i++) {
        CHECK_NEAR(vec2_distance(import.plan.walls[0].points.at[i], vec2(2, 0)), 2, 1e-6);
        lowest = fmin(lowest, import.plan.walls[0].points.at[i].y);
    }
    CHECK_NEAR(lowest, -2, 1e-6);
    end(&import, true);
}

TEST(an_arc_on_a_layer_of_doors_hangs_a_door_in_its_wall_or_in_its_gap) {
    Text entities = {0};
    text_format(&entities, "%s%s", room,
                "0 LINE 8 A-WALL 10 3000 20 0 11 3000 21 1000 0 LINE 8 A-WALL 10 3000 20 1900 11 3000 21 4000 "
                "0 ARC 8 A-DOOR 10 3000 20 1000 40 900 50 90 51 180 "
                "0 ARC 8 A-DOOR 10 1900 20 0 40 900 50 90 51 180 "
                "0 ARC 8 A-DOOR 10 100 20 100 40 50 50 0 51 90");
    Import import = import_drawing(millimetres, "", entities.text, (ImportOptions){0});
    check_lists(&import.plan,
                "  'walls': [\n"
                "    {'id': 'w1', 'points': [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], 'thickness': 0},\n"
                "    {'id': 'w2', 'points': [[3, 0], [3, 1]], 'thickness': 0},\n"
                "    {'id': 'w3', 'points': [[3, 1.9], [3, 4]], 'thickness': 0},\n"
                "    {'id': 'w4', 'points': [[3, 1], [3, 1.9]], 'thickness': 0}\n"
                "  ],\n"
                "  'doors': [\n"
                "    {'id': 'd1', 'wall': 'w4', 'at': 0.45, 'width': 0.9, 'kind': 'hinged'},\n"
                "    {'id': 'd2', 'wall': 'w1', 'at': 1.45, 'width': 0.9, 'kind': 'hinged', 'hinge': 'end'}\n"
                "  ]\n}\n");
    CHECK(is_left(&import, "arcs on door layers that are not door swings", 1));
    end(&import, true);
    memory_free(entities.text);
}

TEST(blocks_in_blocks_are_scaled_turned_and_moved_and_furniture_is_their_box) {
    Text entities = {0};
    text_format(&entities, "%s%s", room, "0 INSERT 8 0 2 SUITE 10 1000 20 1000 50 90 0 INSERT 8 0 2 NOWHERE 10 0 20 0");
    Import import = import_drawing(millimetres,
                                   "0 BLOCK 2 BED 10 100 20 0 0 LINE 8 0 10 100 20 0 11 2100 21 0 0 LINE 8 0 10 2100 "
                                   "20 0 11 2100 21 900 0 ENDBLK "
                                   "0 BLOCK 2 SUITE 10 0 20 0 0 INSERT 8 FURN 2 BED 10 500 20 0 41 0.5 42 1 50 0 0 "
                                   "LINE 8 A-WALL 10 0 20 0 11 1000 21 0 0 ENDBLK",
                                   entities.text, (ImportOptions){0});
    check_lists(&import.plan, "  'walls': [\n"
                              "    {'id': 'w1', 'points': [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], 'thickness': 0},\n"
                              "    {'id': 'w2', 'points': [[1, 1], [1, 2]], 'thickness': 0}\n"
                              "  ],\n"
                              "  'furniture': [\n"
                              "    {'id': 'f1', 'name': 'BED', 'centre': [0.55, 2], 'size': [1, 0.9], 'angle': 90}\n"
                              "  ]\n}\n");
    CHECK(is_left(&import, "blocks missing from the file", 1));
    end(&import, true);
    memory_free(entities.text);
}

TEST(a_unit_that_makes_no_house_is_told_and_not_believed) {
    Import import = import_drawing("9 $INSUNITS 70 6", "", room, (ImportOptions){0});
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 6);
    CHECK(is_noted(&import, "its unit is m, which would make the plan 6000 m by 4000 m: mm is assumed, 6 m by 4 m; "
                            "clearance import --unit overrides"));
    end(&import, true);
    import = import_drawing("", "", room, (ImportOptions){0});
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 6);
    CHECK(is_noted(&import, "does not say its unit: mm is assumed"));
    end(&import, true);
    import = import_drawing("9 $INSUNITS 70 6", "", room, (ImportOptions){.unit = import_unit("cm")});
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 60);
    end(&import, true);
}

TEST(layers_are_chosen_by_their_names_or_as_said) {
    static const char lines[] =
        "0 LINE 8 PLAN|W\u00e4nde 10 0 20 0 11 6000 21 0 0 LINE 8 FOO 10 0 20 1000 11 6000 21 "
        "1000 0 LINE 8 A-DIMS 10 0 20 2000 11 6000 21 2000 0 LWPOLYLINE 8 BAR 90 2 70 0 10 0 20 "
        "0 10 1000 20 0";
    Import import = import_drawing(millimetres, "", lines, (ImportOptions){0});
    CHECK(import.plan.wall_count == 1 && is_left(&import, "lines on layer FOO", 1));
    CHECK(is_noted(&import, "layers taken: PLAN|W\u00e4nde (walls)"));
    end(&import, true);
    import = import_drawing(millimetres, "", lines, (ImportOptions){.layers = "walls=FOO,a-dims,exits=BAR"});
    CHECK(import.plan.wall_count == 2 && import.plan.exit_count == 1);
    end(&import, true);
    import = import_drawing(millimetres, "", lines, (ImportOptions){.layers = "walls=FOOO"});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "there is no layer \"FOOO\", there are 0, "));
    end(&import, false);
    import = import_drawing(millimetres, "", lines, (ImportOptions){.layers = "FOO"});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "--layers must be like walls=NAME"));
    end(&import, false);
}

TEST(old_drawings_are_read_in_the_letters_of_their_code_page) {
    static const char lines[] = "0 LINE 8 \x95\xc7 10 0 20 0 11 6000 21 0 0 LINE 8 W\xc4NDE 10 0 20 0 11 6000 21 0 ";
    Import import = import_drawing("9 $DWGCODEPAGE 3 ANSI_932 9 $INSUNITS 70 4", "", lines, (ImportOptions){0});
    CHECK(is_noted(&import, "layers taken: \u58c1 (walls)"));
    end(&import, true);
    import = import_drawing("9 $DWGCODEPAGE 3 ANSI_1252 9 $INSUNITS 70 4", "", lines, (ImportOptions){0});
    CHECK(is_noted(&import, "layers taken: W\u00c4NDE (walls)"));
    end(&import, true);
    import = import_drawing("9 $DWGCODEPAGE 3 ANSI_99 9 $INSUNITS 70 4", "", lines, (ImportOptions){0});
    CHECK(is_noted(&import, "layers taken: W\u00c4NDE (walls)"));
    end(&import, true);
}

TEST(a_plan_in_the_coordinates_of_a_survey_is_brought_to_its_origin) {
    Import import = import_drawing(
        "9 $INSUNITS 70 6", "", "0 LINE 8 WALL 10 3500100.25 20 5600200 11 3500110.25 21 5600200", (ImportOptions){0});
    check_lists(&import.plan,
                "  'walls': [\n    {'id': 'w1', 'points': [[0.25, 0], [10.25, 0]], 'thickness': 0}\n  ]\n}\n");
    CHECK(is_noted(&import, "the plan was moved by (-3500100, -5600200) m to the origin"));
    end(&import, true);
}

/* Walkable areas -------------------------------------------------------------------------------------------------- */

TEST(areas_side_by_side_are_one_and_holes_are_obstacles) {
    Import import = import_text(".wkt",
                                "GEOMETRYCOLLECTION (POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0), (2 2, 3 2, 3 3, 2 3, 2 2)),\n"
                                "  POLYGON ((8 1, 10 1, 10 3, 8 3, 8 1)), POINT (1 1))\nLINESTRING (1 4, 2 4)\n",
                                (ImportOptions){0});
    check_lists(&import.plan,
                "  'walls': [\n"
                "    {'id': 'w1', 'points': [[1, 4], [2, 4]], 'thickness': 0},\n"
                "    {'id': 'w2', 'points': [[10, 3], [10, 1], [8, 1], [8, 0], [0, 0], [0, 6], [8, 6], [8, "
                "3], [10, 3]], 'thickness': 0},\n"
                "    {'id': 'w3', 'points': [[3, 2], [3, 3], [2, 3], [2, 2], [3, 2]], 'thickness': 0}\n"
                "  ]\n}\n");
    CHECK(is_left(&import, "points", 1));
    end(&import, true);
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
    Import import = import_text(".wkt", once ? once : "", (ImportOptions){0});
    char *twice = walkable_wkt(&import.plan, &fault);
    CHECK(twice);
    if (once && twice)
        CHECK_NEAR(area_of(twice), area_of(once), 1e-6);
    end(&import, true);
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

/* Vadere ---------------------------------------------------------------------------------------------------------- */

/* Writes a scenario from a topography without its frame; ' stands for quotation marks. */
static Import import_scenario(const char *release, const char *topography) {
    Text text = {0};
    text_format(
        &text,
        "{'name': 'corner', 'release': '%s', 'scenario': {'topography': {'attributes': {'bounds': {'x': 0, 'y': "
        "0, 'width': 12, 'height': 16}, 'boundingBoxWidth': 1, 'bounded': true}, 'obstacles': ["
        "{'shape': {'type': 'RECTANGLE', 'x': 0.5, 'y': 4, 'width': 8, 'height': 0.5}}, "
        "{'shape': {'type': 'RECTANGLE', 'x': 8, 'y': 4.5, 'width': 0.5, 'height': 7}}, "
        "{'shape': {'type': 'RECTANGLE', 'x': 2, 'y': 6, 'width': 2, 'height': 1}}], 'stairs': [{}, {}], "
        "'dynamicElements': [{'type': 'PEDESTRIAN', 'position': {'x': 7.25, 'y': 2}, 'freeFlowSpeed': 1.5, "
        "'targetIds': [2, 1]}, {'type': 'PEDESTRIAN', 'position': {'x': 5, 'y': 4.25}, 'targetIds': [1]}], "
        "%s}}}",
        release, topography);
    for (char *c = text.text; *c; c++)
        *c = *c == '\'' ? '"' : *c;
    Import import = import_text(".scenario", text.text, (ImportOptions){0});
    memory_free(text.text);
    return import;
}

static const char corner[] =
    "  'walls': [\n"
    "    {'id': 'w1', 'points': [[0.5, 0.5], [11.5, 0.5], [11.5, 15.5], [0.5, 15.5], [0.5, 0.5]], 'thickness': 1},\n"
    "    {'id': 'w2', 'points': [[0.5, 4.25], [8.5, 4.25]], 'thickness': 0.5, 'height': 2},\n"
    "    {'id': 'w3', 'points': [[8.25, 4.5], [8.25, 11.5]], 'thickness': 0.5, 'height': 2}\n"
    "  ],\n"
    "  'furniture': [\n"
    "    {'id': 'f1', 'name': 'obstacle', 'centre': [3, 6.5], 'size': [2, 1], 'height': 2}\n"
    "  ],\n"
    "  'exits': [\n"
    "    {'id': 'e1', 'from': [9, 13.5], 'to': [11, 13.5]}\n"
    "  ],\n"
    "  'people': [\n"
    "    {'id': 'p1', 'profile': 'adult', 'at': [7.25, 2], 'speed': 1.5}\n"
    "  ],\n"
    "  'crowds': [\n"
    "    {'id': 'c1', 'profile': 'adult', 'count': 18, 'area': [[1.5, 1.5], [6.5, 1.5], [6.5, 3.5], [1.5, 3.5]], "
    "'delay': 5}\n"
    "  ],\n"
    "  'routes': [\n"
    "    {'id': 'route1', 'people': ['c1', 'p1'], 'via': [[10, 3]], 'exit': 'e1'}\n"
    "  ]\n}\n";

TEST(a_scenario_says_the_same_in_the_words_of_old_and_new_releases) {
    Import import = import_scenario(
        "2.4", "'targets': [{'id': 1, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 12.5, 'width': 2, 'height': 2}, "
               "'absorber': {'enabled': true}}, {'id': 2, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 2, 'width': 2, "
               "'height': 2}, 'absorber': {'enabled': false}}], 'sources': [{'shape': {'type': 'RECTANGLE', 'x': 1.5, "
               "'y': 1.5, 'width': 5, 'height': 2}, 'targetIds': [2, 1], 'spawner': {'constraintsTimeStart': 5, "
               "'constraintsTimeEnd': 5, 'eventElementCount': 18}}]");
    check_lists(&import.plan, corner);
    CHECK(is_left(&import, "stairs", 2) && is_left(&import, "people who stand inside an obstacle", 1));
    CHECK_TEXT(import.plan.name, "corner");
    end(&import, true);
    import = import_scenario(
        "1.15",
        "'targets': [{'id': 1, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 12.5, 'width': 2, 'height': 2}, "
        "'absorbing': true}, {'id': 2, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 2, 'width': 2, 'height': 2}, "
        "'absorbing': false}], 'sources': [{'shape': {'type': 'RECTANGLE', 'x': 1.5, 'y': 1.5, 'width': 5, "
        "'height': 2}, 'targetIds': [2, 1], 'startTime': 5, 'endTime': 5, 'spawnNumber': 18}]");
    check_lists(&import.plan, corner);
    end(&import, true);
}

TEST(a_source_gives_no_more_people_than_it_has_room_for) {
    Import import = import_scenario(
        "2.4",
        "'teleporter': null, 'targets': [{'id': 1, 'shape': {'type': 'POLYGON', 'points': [{'x': 2, 'y': 12}, {'x': "
        "6, 'y': 12}, {'x': 6, 'y': 13}]}}], 'sources': [{'shape': {'type': 'CIRCLE', 'radius': 0.5, 'center': "
        "{'x': 10, 'y': 10}}, 'spawner': {'eventElementCount': 50}}]");
    CHECK(import.plan.exit_count == 1 && import.plan.crowd_count == 1);
    CHECK(import.good && import.plan.crowds[0].count == 2 && import.plan.crowds[0].area.count == 24);
    CHECK(is_left(&import, "people for whom their source is too small", 48));
    end(&import, true);
}

/* Bad files ------------------------------------------------------------------------------------------------------- */

static void read_bad(const char *path, Fault *fault) {
    Plan plan = {.name = "untouched"};
    ImportReport report = {0};
    CHECK(!import_read(&plan, path, &(ImportOptions){0}, &report, fault));
    CHECK(fault->total == 1);
    CHECK_TEXT(plan.name, "untouched");
    import_report_clear(&report);
}

TEST(a_bad_file_is_refused_in_one_line_that_says_where) {
    scratch_check_faults("tests/data/bad/imports", read_bad);
}

TEST(a_file_of_another_kind_is_refused_by_its_ending) {
    Import import = import_text(".txt", "POLYGON ((0 0, 4 0, 4 3, 0 0))", (ImportOptions){0});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "must end in .sh3d, .dxf, .wkt or .scenario"));
    end(&import, false);
    CHECK(import_is_file("a.DXF") && !import_is_file("dxf") && !import_is_file(".dxf"));
    CHECK(import_unit("inch") == 0.0254 && import_unit("parsec") == 0);
}
