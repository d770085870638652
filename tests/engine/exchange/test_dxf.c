#include "check.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "exchange/block_name.h"
#include "exchange/length_text.h"
#include "imported.h"

/* Turns groups of a drawing, "0 LINE 8 WALL 10 0 ...", into lines. */
static Imported import_drawing(const char *header, const char *blocks, const char *entities, ImportOptions options) {
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
    Imported import = imported_text(".dxf", text.text, options);
    memory_free(text.text);
    return import;
}

static const char millimetres[] = "9 $INSUNITS 70 4";
static const char room[] = "0 LWPOLYLINE 8 A-WALL 90 4 70 1 10 0 20 0 10 6000 20 0 10 6000 20 4000 10 0 20 4000 ";

TEST(lines_of_a_drawing_are_joined_into_walls) {
    Imported import =
        import_drawing(millimetres, "",
                       "0 LINE 8 A-WALL 10 0 20 0 11 3000 21 0 0 LINE 8 A-WALL 10 6000 20 0 11 3000 21 0 "
                       "0 LINE 8 A-WALL 10 6000 20 0 11 6000 21 4000 0 LINE 8 A-WALL 10 0 20 0 11 3000 21 0 "
                       "0 POLYLINE 8 A-WALL 70 0 40 100 0 VERTEX 10 0 20 2000 0 VERTEX 10 2000 20 2000 0 SEQEND",
                       (ImportOptions){0});
    imported_check_lists(&import.plan, "  'walls': [\n"
                                       "    {'id': 'w1', 'points': [[0, 0], [6, 0], [6, 4]], 'thickness': 0},\n"
                                       "    {'id': 'w2', 'points': [[0, 2], [2, 2]], 'thickness': 0.1}\n"
                                       "  ]\n}\n");
    CHECK(imported_noted(&import, "the unit is mm, as the file says: the plan is 6 m by 4 m"));
    CHECK(!imported_left_out(&import, "SEQEND", 1));
    imported_end(&import, true);
}

TEST(groups_of_an_entity_may_have_any_order_and_those_with_a_default_may_be_missing) {
    Imported import =
        import_drawing(millimetres, "0 BLOCK 8 0 2 BED 0 LINE 8 0 10 0 20 0 11 2000 21 900 0 ENDBLK",
                       "0 LINE 11 3000 10 0 21 4000 20 1000 8 A-WALL 0 LWPOLYLINE 8 A-WALL 90 0 70 0 "
                       "0 POLYLINE 8 A-WALL 66 1 70 64 0 VERTEX 70 192 10 0 20 0 0 VERTEX 70 128 71 1 72 2 73 3 "
                       "0 SEQEND 0 POLYLINE 8 A-WALL 70 4 0 VERTEX 70 16 0 VERTEX 10 0 20 0 0 VERTEX 10 0 20 1000 "
                       "0 INSERT 8 FURN 2 BED 10 1000 20 3000",
                       (ImportOptions){0});
    imported_check_lists(&import.plan, "  'walls': [\n"
                                       "    {'id': 'w1', 'points': [[0, 0], [0, 1], [3, 4]], 'thickness': 0}\n"
                                       "  ],\n"
                                       "  'furniture': [\n"
                                       "    {'id': 'f1', 'name': 'bed', 'centre': [2, 3.45], 'size': [2, 0.9]}\n"
                                       "  ]\n}\n");
    imported_end(&import, true);
}

TEST(a_drawing_ends_with_eof_also_within_a_section) {
    Imported import = imported_text(".dxf",
                                    "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nWALL\n10\n0\n20\n0\n11\n8\n21\n3\n"
                                    "0\nEOF\n\n\x1a",
                                    (ImportOptions){.unit = 1});
    CHECK(import.plan.wall_count == 1);
    imported_end(&import, true);
}

TEST(a_slender_rectangle_is_a_wall_as_thick_as_it_is_and_a_stout_one_is_its_sides) {
    Imported import =
        import_drawing(millimetres, "",
                       "0 LWPOLYLINE 8 WALL 90 4 70 1 10 0 20 0 10 4000 20 0 10 4000 20 200 10 0 20 200 "
                       "0 LWPOLYLINE 8 WALL 90 4 70 1 10 0 20 1000 10 400 20 1000 10 400 20 1300 10 0 20 1300",
                       (ImportOptions){0});
    imported_check_lists(&import.plan,
                         "  'walls': [\n"
                         "    {'id': 'w1', 'points': [[0, 0.1], [4, 0.1]], 'thickness': 0.2},\n"
                         "    {'id': 'w2', 'points': [[0, 1], [0.4, 1], [0.4, 1.3], [0, 1.3], [0, 1]], 'thickness': "
                         "0}\n"
                         "  ]\n}\n");
    CHECK(imported_noted(&import, "walls are the lines and rectangles that are drawn; heights are assumed"));
    imported_end(&import, true);
}

TEST(a_bulge_is_an_arc_to_the_right_of_its_way_when_positive) {
    Imported import = import_drawing(millimetres, "", "0 LWPOLYLINE 8 WALL 90 2 70 0 10 0 20 0 42 1 10 4000 20 0",
                                     (ImportOptions){0});
    double lowest = 0;
    for (size_t i = 0; import.good && i < import.plan.walls[0].points.count; i++) {
        CHECK_NEAR(vec2_distance(import.plan.walls[0].points.at[i], vec2(2, 0)), 2, 1e-6);
        lowest = fmin(lowest, import.plan.walls[0].points.at[i].y);
    }
    CHECK_NEAR(lowest, -2, 1e-6);
    imported_end(&import, true);
}

TEST(an_arc_on_a_layer_of_doors_hangs_a_door_in_its_wall_or_in_its_gap) {
    Text entities = {0};
    text_format(&entities, "%s%s", room,
                "0 LINE 8 A-WALL 10 3000 20 0 11 3000 21 1000 0 LINE 8 A-WALL 10 3000 20 1900 11 3000 21 4000 "
                "0 ARC 8 A-DOOR 10 3000 20 1000 40 900 50 90 51 180 "
                "0 ARC 8 A-DOOR 10 1900 20 0 40 900 50 90 51 180 "
                "0 ARC 8 A-DOOR 10 100 20 100 40 50 50 0 51 90");
    Imported import = import_drawing(millimetres, "", entities.text, (ImportOptions){0});
    imported_check_lists(&import.plan,
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
    CHECK(imported_left_out(&import, "arcs on door layers that are not door swings", 1));
    imported_end(&import, true);
    memory_free(entities.text);
}

TEST(blocks_in_blocks_are_scaled_turned_and_moved_and_furniture_is_their_box) {
    Text entities = {0};
    text_format(&entities, "%s%s", room, "0 INSERT 8 0 2 SUITE 10 1000 20 1000 50 90 0 INSERT 8 0 2 NOWHERE 10 0 20 0");
    Imported import = import_drawing(millimetres,
                                     "0 BLOCK 2 BED 10 100 20 0 0 LINE 8 0 10 100 20 0 11 2100 21 0 0 LINE 8 0 10 2100 "
                                     "20 0 11 2100 21 900 0 ENDBLK "
                                     "0 BLOCK 2 SUITE 10 0 20 0 0 INSERT 8 FURN 2 BED 10 500 20 0 41 0.5 42 1 50 0 0 "
                                     "LINE 8 A-WALL 10 0 20 0 11 1000 21 0 0 ENDBLK",
                                     entities.text, (ImportOptions){0});
    imported_check_lists(&import.plan,
                         "  'walls': [\n"
                         "    {'id': 'w1', 'points': [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], 'thickness': 0},\n"
                         "    {'id': 'w2', 'points': [[1, 1], [1, 2]], 'thickness': 0}\n"
                         "  ],\n"
                         "  'furniture': [\n"
                         "    {'id': 'f1', 'name': 'bed', 'centre': [0.55, 2], 'size': [1, 0.9], 'angle': 90}\n"
                         "  ]\n}\n");
    CHECK(imported_left_out(&import, "blocks missing from the file", 1));
    imported_end(&import, true);
    memory_free(entities.text);
}

TEST(a_block_is_called_by_its_kind_of_furniture) {
    static const char *const names[][2] = {{"xref-Bishop-Overland-08$0$FIXT-OVALBATH", "bath tub"},
                                           {"plan|A-BATH-SINK", "sink"},
                                           {"BED", "bed"},
                                           {"WC_01", "toilet"},
                                           {"NEWCASTLE$2$", "furniture"},
                                           {"A$C0B2", "furniture"},
                                           {"Sideboard", "Sideboard"},
                                           {"$0", "furniture"},
                                           {"", "furniture"},
                                           {"CHAIR-ARMCHAIR", "armchair"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        CHECK_TEXT(block_name_of(names[i][0]), names[i][1]);
    Text entities = {0};
    text_format(&entities, "%s%s", room, "0 INSERT 8 FURN 2 xref-a$0$FIXT-OVALBATH 10 1000 20 1000");
    Imported import = import_drawing(millimetres,
                                     "0 BLOCK 2 xref-a$0$FIXT-OVALBATH 10 0 20 0 0 LINE 8 0 10 0 20 0 11 1700 21 0 0 "
                                     "LINE 8 0 10 1700 20 0 11 1700 21 700 0 ENDBLK",
                                     entities.text, (ImportOptions){0});
    CHECK(import.plan.furniture_count == 1);
    CHECK_TEXT(import.plan.furniture[0].name, "bath tub");
    CHECK(imported_noted(&import,
                         "pieces of furniture are called by their kind (1): xref-a$0$FIXT-OVALBATH became bath "
                         "tub"));
    imported_end(&import, true);
    memory_free(entities.text);
}

TEST(a_unit_that_makes_no_house_is_noted_and_the_doors_decide) {
    static const char door[] = "0 ARC 8 A-DOOR 10 1900 20 0 40 900 50 90 51 180 ";
    Text entities = {0};
    text_format(&entities, "%s%s", room, door);
    Imported import = import_drawing("9 $INSUNITS 70 6", "", entities.text, (ImportOptions){0});
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 6);
    CHECK(imported_noted(&import, "the unit is mm, as the doors say: the median leaf is 0.9 m wide, the plan is 6 m"));
    CHECK(imported_noted(&import, "its unit is m, which would make the plan 6000 m by 4000 m. Use --unit to "
                                  "override"));
    imported_end(&import, true);
    memory_free(entities.text);
}

static void check_refused(const char *header, const char *entities, const char *says) {
    Imported import = import_drawing(header, "", entities, (ImportOptions){0});
    CHECK(import.fault.count == 1 && strstr(import.fault.lines[0], says));
    imported_end(&import, false);
}

TEST(a_doubtful_unit_is_refused_with_the_sizes_that_each_unit_gives) {
    check_refused("", room,
                  "the file does not say its unit, and nothing else does: the plan would be 6 m by 4 m in mm, 60 m by "
                  "40 m in cm, 152.4 m by 101.6 m in inch, say --unit mm|cm|m|inch|ft");
    check_refused("9 $INSUNITS 70 6", room,
                  "the file says that its unit is m, which would make the plan 6000 m by 4000 m, and nothing else "
                  "confirms it: the plan would be 6 m by 4 m in mm, ");
    Imported import = import_drawing("9 $INSUNITS 70 6", "", room, (ImportOptions){.unit = import_unit("cm")});
    CHECK(import.good && import.plan.walls[0].points.at[1].x == 60);
    imported_end(&import, true);
}

/* A room of 192 by 240 with a dimension of 192. */
static const char inches[] = "0 LWPOLYLINE 8 WALL 90 4 70 1 10 0 20 0 10 192 20 0 10 192 20 240 10 0 20 240 ";

static void check_dimension(const char *header, const char *blocks, const char *dimension, const char *says) {
    Text entities = {0};
    text_format(&entities, "%s%s", inches, dimension);
    Imported import = import_drawing(header, blocks, entities.text, (ImportOptions){0});
    CHECK(import.good);
    if (import.good)
        CHECK_NEAR(import.plan.walls[0].points.at[1].x, 192 * 0.0254, 1e-9);
    CHECK(imported_noted(&import, says));
    imported_end(&import, true);
    memory_free(entities.text);
}

TEST(dimensions_say_the_unit_whatever_the_header_says) {
    static const char feet[] = "the unit is inch, as the dimensions say: 16'-0\" measures 192; the plan is 4.877 m by ";
    check_dimension("9 $INSUNITS 70 5", "", "0 DIMENSION 8 DIM 1 16'-0\" 70 1 13 0 23 9 14 192 24 9", feet);
    check_dimension("9 $INSUNITS 70 5", "", "0 DIMENSION 8 DIM 1 16'-0\" 70 32 42 192.0", feet);
    check_dimension("9 $INSUNITS 70 5", "", "0 DIMENSION 8 DIM 1 16'-0\" 70 1 14 6000 24 9 42 192.0", feet);
    check_dimension("", "0 BLOCK 2 *D1 10 0 20 0 0 MTEXT 8 DIM 10 0 20 0 1 \\A1;16'-0\" 0 ENDBLK",
                    "0 DIMENSION 8 DIM 2 *D1 70 33 13 0 23 9 14 192 24 9", feet);
    check_dimension("", "", "0 DIMENSION 8 DIM 1 4877 70 0 13 0 23 9 14 192 24 30", "4877 measures 192");
    check_dimension("", "", "0 DIMENSION 8 DIM 1 4,88 70 1 13 0 23 9 14 192 24 9", "4,88 measures 192");
    check_dimension("", "",
                    "0 TEXT 8 DIM 10 90 20 13 40 6 1 16'-0\" 0 LINE 8 DIM 10 0 20 10 11 192 21 10 "
                    "0 TEXT 8 DIM 10 -3 20 100 40 6 50 90 1 20' 0 LINE 8 DIM 10 0 20 0 11 0 21 240",
                    feet);
    check_dimension("9 $LUNITS 70 4", "", "", "the unit is inch, as the file says");
}

TEST(dimensions_that_show_what_they_measure_say_nothing) {
    Text entities = {0};
    text_format(&entities, "%s%s", room, "0 DIMENSION 8 DIM 1 6000 70 1 13 0 23 9 14 6000 24 9");
    check_refused("", entities.text, "the file does not say its unit");
    memory_free(entities.text);
}

static void check_length(const char *text, double metres, bool has_unit) {
    LengthText length;
    CHECK(length_text_read(text, 1.5, &length));
    CHECK_NEAR(length.value, metres, 1e-12);
    CHECK(length.has_unit == has_unit);
}

TEST(lengths_are_read_as_drawings_write_them) {
    check_length("16'-0\"", 4.8768, true);
    check_length("{\\fArial|b0|i0;\\A1;4'-10\\S1/2;\"}", 4 * 0.3048 + 10.5 * 0.0254, true);
    check_length("4' 10-1/2\"", 4 * 0.3048 + 10.5 * 0.0254, true);
    check_length("10 1/2''", 10.5 * 0.0254, true);
    check_length("3/4\"", 0.75 * 0.0254, true);
    check_length("16\u2032", 16 * 0.3048, true);
    check_length("4.88 m", 4.88, true);
    check_length("4,88m", 4.88, true);
    check_length("488 CM", 4.88, true);
    check_length("<> mm", 0.0015, true);
    check_length("4877", 4877, false);
    LengthText length;
    static const char *const others[] = {"", "BEDROOM", "12' x 14'", "%%c20", "1/0\"", "-3 m", "5 %", "\\S"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        CHECK(!length_text_read(others[i], 1, &length));
}

TEST(layers_are_chosen_by_their_names_or_as_said) {
    static const char lines[] =
        "0 LINE 8 PLAN|W\u00e4nde 10 0 20 0 11 6000 21 0 0 LINE 8 FOO 10 0 20 1000 11 6000 21 "
        "1000 0 LINE 8 A-DIMS 10 0 20 2000 11 6000 21 2000 0 LWPOLYLINE 8 BAR 90 2 70 0 10 0 20 "
        "0 10 1000 20 0";
    Imported import = import_drawing(millimetres, "", lines, (ImportOptions){0});
    CHECK(import.plan.wall_count == 1 && imported_left_out(&import, "lines on layer FOO", 1));
    CHECK(imported_noted(&import, "layers taken: PLAN|W\u00e4nde (walls)"));
    imported_end(&import, true);
    import = import_drawing(millimetres, "", lines, (ImportOptions){.layers = "walls=FOO,a-dims,exits=BAR"});
    CHECK(import.plan.wall_count == 2 && import.plan.exit_count == 1);
    imported_end(&import, true);
    import = import_drawing(millimetres, "", lines, (ImportOptions){.layers = "walls=FOOO"});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "there is no layer \"FOOO\", there are 0, "));
    imported_end(&import, false);
    import = import_drawing(millimetres, "", lines, (ImportOptions){.layers = "FOO"});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "--layers must be like walls=NAME"));
    imported_end(&import, false);
}

TEST(old_drawings_are_read_in_the_letters_of_their_code_page) {
    static const char lines[] = "0 LINE 8 \x95\xc7 10 0 20 0 11 6000 21 0 0 LINE 8 W\xc4NDE 10 0 20 0 11 6000 21 0 ";
    Imported import = import_drawing("9 $DWGCODEPAGE 3 ANSI_932 9 $INSUNITS 70 4", "", lines, (ImportOptions){0});
    CHECK(imported_noted(&import, "layers taken: \u58c1 (walls)"));
    imported_end(&import, true);
    import = import_drawing("9 $DWGCODEPAGE 3 ANSI_1252 9 $INSUNITS 70 4", "", lines, (ImportOptions){0});
    CHECK(imported_noted(&import, "layers taken: W\u00c4NDE (walls)"));
    imported_end(&import, true);
    import = import_drawing("9 $DWGCODEPAGE 3 ANSI_99 9 $INSUNITS 70 4", "", lines, (ImportOptions){0});
    CHECK(imported_noted(&import, "layers taken: W\u00c4NDE (walls)"));
    imported_end(&import, true);
}

TEST(a_plan_in_the_coordinates_of_a_survey_is_brought_to_its_origin) {
    Imported import = import_drawing(
        "9 $INSUNITS 70 6", "", "0 LINE 8 WALL 10 3500100.25 20 5600200 11 3500110.25 21 5600200", (ImportOptions){0});
    imported_check_lists(&import.plan,
                         "  'walls': [\n    {'id': 'w1', 'points': [[0.25, 0], [10.25, 0]], 'thickness': 0}\n  ]\n}\n");
    CHECK(imported_noted(&import, "the plan was moved by (-3500100, -5600200) m to the origin"));
    imported_end(&import, true);
}
