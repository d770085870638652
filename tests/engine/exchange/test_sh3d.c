#include "check.h"

#include <math.h>
#include <string.h>
#include <zip.h>

#include "base/text.h"
#include "imported.h"

/* Writes a zip file with one text. */
static void write_zip(const char *path, const char *name, const char *text) {
    int error = 0;
    zip_t *zip = zip_open(path, ZIP_CREATE | ZIP_EXCL, &error);
    CHECK(zip);
    zip_source_t *source = zip_source_buffer(zip, text, strlen(text), 0);
    CHECK(zip_file_add(zip, name, source, 0) >= 0);
    CHECK(zip_close(zip) == 0);
}

static Imported import_home(const char *elements, ImportOptions options) {
    char path[IMPORTED_PATH];
    Text xml = {0};
    text_format(&xml, "<?xml version='1.0'?>\n<home version='7200' name='/somewhere/else.sh3d'>\n%s\n</home>",
                elements);
    write_zip(imported_path(path, ".sh3d"), "Home.xml", xml.text);
    memory_free(xml.text);
    return imported_file(path, options);
}

static const char box_walls[] =
    "<wall id='a' wallAtEnd='b' xStart='0' yStart='0' xEnd='600' yEnd='0' height='250' thickness='10'/>"
    "<wall id='b' xStart='600' yStart='0' xEnd='600' yEnd='400' height='250' thickness='10'/>"
    "<wall id='c' xStart='600' yStart='400' xEnd='0' yEnd='400' height='250' thickness='10'/>"
    "<wall id='d' xStart='0' yStart='400' xEnd='0' yEnd='0' height='250' thickness='10'/>"
    "<wall id='m' xStart='400' yStart='0' xEnd='400' yEnd='400' height='240' thickness='7.5'/>";

static Imported import_box(const char *elements, ImportOptions options) {
    Text all = {0};
    text_format(&all, "%s%s", box_walls, elements);
    Imported import = import_home(all.text, options);
    memory_free(all.text);
    return import;
}

TEST(walls_that_meet_end_to_end_are_one_and_centimetres_down_the_screen_become_metres_up) {
    Imported import = import_box("", (ImportOptions){0});
    imported_check_lists(&import.plan,
                         "  'walls': [\n"
                         "    {'id': 'w1', 'points': [[0, 0], [6, 0], [6, -4], [0, -4], [0, 0]], 'thickness': "
                         "0.1, 'height': 2.5},\n"
                         "    {'id': 'w2', 'points': [[4, 0], [4, -4]], 'thickness': 0.075}\n"
                         "  ]\n}\n");
    CHECK(imported_noted(&import, "the house has no exit yet"));
    CHECK(strstr(import.plan.note, ".sh3d (Sweet Home 3D)"));
    imported_end(&import, true);
}

TEST(a_door_is_as_wide_as_its_sashes_and_hangs_and_swings_as_drawn) {
    Imported import = import_box(
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
    imported_end(&import, true);
}

static const char slider[] =
    "<doorOrWindow catalogId='eTeks#sliderWindow126x200' name='Sliding window' x='200' y='400' width='126' depth='12' "
    "elevation='5' height='200'><sash xAxis='0.05' yAxis='0.4' width='0.45' startAngle='0' endAngle='0'/><sash "
    "xAxis='0.5' yAxis='0.6' width='0.45' startAngle='0' endAngle='0'/></doorOrWindow>";

TEST(a_sliding_window_at_the_floor_is_a_door_as_wide_as_the_leaf_that_opens) {
    Imported import = import_box(slider, (ImportOptions){0});
    CHECK(import.plan.door_count == 1 &&
          imported_left_out(&import, "further leaves of sliding doors: the widest leaf opens", 1));
    if (import.plan.door_count == 1) {
        CHECK(import.plan.doors[0].kind == DOOR_SLIDING);
        CHECK_NEAR(import.plan.doors[0].width, 0.45 * 1.26, 1e-9);
    }
    imported_end(&import, true);
    import = import_box("<doorOrWindow catalogId='eTeks#fixedWindow85x123' name='Fixed window' x='200' y='400' "
                        "width='126' depth='12' elevation='0' height='220'/>"
                        "<doorOrWindow name='Sliding window' x='200' y='0' width='126' depth='12' elevation='29' "
                        "height='200'><sash width='0.5'/></doorOrWindow>",
                        (ImportOptions){0});
    CHECK(import.plan.door_count == 0 && imported_left_out(&import, "windows", 2));
    imported_end(&import, true);
}

TEST(a_door_that_repeats_another_one_is_left_out_for_that_reason) {
    Text all = {0};
    text_format(&all, "%s%s", slider, slider);
    Imported import = import_box(all.text, (ImportOptions){0});
    CHECK(import.plan.door_count == 1);
    CHECK(imported_left_out(&import, "doors that stand in the place of an earlier door", 1));
    imported_end(&import, true);
    memory_free(all.text);
}

TEST(a_home_that_holds_its_plan_twice_says_so_and_counts_once) {
    static const char room[] =
        "<room name='Hall'><point x='5' y='5'/><point x='395' y='5'/><point x='395' y='395'/><point "
        "x='5' y='395'/></room>";
    static const char bed[] = "<pieceOfFurniture name='Bed' x='100' y='100' width='90' depth='200' height='50'/>";
    Text all = {0};
    text_format(&all, "%s%s%s%s%s", box_walls, room, bed, room, bed);
    Imported import = import_box(all.text, (ImportOptions){0});
    CHECK(import.plan.room_count == 1 && import.plan.furniture_count == 1 && import.plan.wall_count == 2);
    CHECK(imported_noted(&import, "walls drawn more than once count once (5)"));
    CHECK(imported_noted(&import, "furniture that stands more than once in the same place counts once (1)"));
    CHECK(imported_noted(&import, "rooms with the same outline count once (1)"));
    imported_end(&import, true);
    memory_free(all.text);
}

TEST(rooms_that_overlap_and_walls_that_cover_them_are_noted) {
    Imported import = import_box("<room><point x='5' y='5'/><point x='395' y='5'/><point x='395' y='395'/><point x='5' "
                                 "y='395'/></room><room><point x='8' y='9'/><point x='398' y='9'/><point x='398' "
                                 "y='399'/><point x='8' y='399'/></room>",
                                 (ImportOptions){0});
    CHECK(imported_noted(&import,
                         "the rooms overlap: they have 30.42 m2 together and cover 15.48 m2; the file may hold "
                         "its plan more than once"));
    imported_end(&import, true);
    import = import_box("<room><point x='390' y='5'/><point x='410' y='5'/><point x='410' y='395'/><point x='390' "
                        "y='395'/></room>",
                        (ImportOptions){0});
    CHECK(imported_noted(&import, "walls cover 0.2925 m2 of the rooms' 0.78 m2"));
    imported_end(&import, true);
}

TEST(windows_lamps_hidden_things_and_rugs_stand_in_nobody_s_way) {
    Imported import = import_box(
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
    CHECK(imported_left_out(&import, "windows", 1) && imported_left_out(&import, "pieces that hang above 1.8 m", 1));
    CHECK(imported_left_out(&import, "pieces that are hidden", 1) &&
          imported_left_out(&import, "rugs and the like, up to 3 cm high", 1));
    CHECK(imported_left_out(&import, "texts", 1) && imported_left_out(&import, "drawn lines", 1));
    imported_end(&import, true);
}

static const char storeys[] =
    "<level id='u' name='Upper' elevation='260'/><level id='g' name='Ground' elevation='0'/>"
    "<wall level='u' xStart='0' yStart='0' xEnd='500' yEnd='0' thickness='10'/>"
    "<wall level='g' xStart='0' yStart='0' xEnd='700' yEnd='0' thickness='10'/>"
    "<room level='g' name='Hall'><point x='0' y='0'/><point x='700' y='0'/><point x='700' y='100'/></room>";

TEST(one_storey_is_taken_the_lowest_or_the_one_that_is_named) {
    Imported import = import_home(storeys, (ImportOptions){0});
    CHECK(import.plan.wall_count == 1 && import.plan.room_count == 1);
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 7);
    CHECK(imported_noted(&import, "\"Ground\", is imported; choose another of \"Upper\", \"Ground\""));
    imported_end(&import, true);
    import = import_home(storeys, (ImportOptions){.level = "Upper"});
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 5);
    CHECK(imported_left_out(&import, "walls, rooms and furniture on other storeys", 2));
    imported_end(&import, true);
    import = import_home(storeys, (ImportOptions){.level = "Cellar"});
    CHECK(import.fault.count &&
          strstr(import.fault.lines[0], "unknown storey \"Cellar\", the storeys are \"Upper\", \"Ground\""));
    imported_end(&import, false);
}

TEST(a_round_wall_bulges_to_the_side_it_is_drawn_on) {
    Imported import = import_home("<wall xStart='700' yStart='0' xEnd='700' yEnd='400' thickness='10' "
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
    imported_end(&import, true);
}

TEST(a_zip_that_unpacks_to_too_much_is_refused_before_it_does) {
    char path[IMPORTED_PATH];
    size_t size = 8 * 1024 * 1024;
    char *blank = memory_zeroed(size + 1, 1);
    memset(blank, ' ', size);
    memcpy(blank, "<home>", 6);
    write_zip(imported_path(path, ".sh3d"), "Home.xml", blank);
    Imported import = imported_file(path, (ImportOptions){0});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "compressed more than 200 times"));
    imported_end(&import, false);
    memory_free(blank);
}
