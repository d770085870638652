#include "check.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "captions.h"
#include "draw/caption.h"
#include "paint/cairo_file.h"
#include "draw/layout.h"
#include "paint/paint_cairo.h"
#include "draw/text.h"
#include "result/census.h"
#include "visual/house/house_scene.h"
#include "visual/house/silhouette.h"

static const Vec2 PAGE = {1280, 720};

/* A scene of 6 m by 4 m with text in every possible place. */
static Scene plain_scene(void) {
    Scene scene = {.box = {{0, 0}, {6, 4}},
                   .grid = 1,
                   .title = "Out in 18.4 s",
                   .title_role = ROLE_TEXT,
                   .detail = "narrowest 0.06 m at door d2, no contact",
                   .name = "a house",
                   .note = "assumed plan: not measured",
                   .clock = "0 to 18.4 s"};
    scene_add_row(&scene, ROW_HEADING, "Dangerous points");
    SceneRow *row = scene_add_row(&scene, ROW_DISC, "door d2");
    row->role = ROLE_DANGER_HIGH;
    row->mark = "1";
    row->cells[1] = "0.06 m";
    row->cells[2] = "410 N";
    return scene;
}

static void check_words(const Layout *layout) {
    for (size_t i = 0; i < layout->caption_count; i++) {
        Box box = caption_box(&layout->captions[i]);
        CHECK(box.low.x >= 0 && box.low.y >= 0 && box.high.x <= layout->page.x && box.high.y <= layout->page.y);
        CHECK(layout->captions[i].size >= LAYOUT_SMALLEST_TEXT);
        for (size_t j = i + 1; j < layout->caption_count; j++)
            CHECK(!captions_overlap(box, caption_box(&layout->captions[j])));
    }
}

TEST(a_scene_keeps_copies_of_points_and_texts) {
    Scene scene = {0};
    Vec2 points[] = {{0, 0}, {1, 0}, {1, 1}};
    char text[] = "bed";
    scene_add_polygon(&scene, ROLE_FURNITURE, points, 3);
    scene_add_label(&scene, ROLE_TEXT, 17, points[0], text);
    points[2] = vec2(9, 9);
    text[0] = 'X';
    CHECK_NEAR(scene.primitives[0].points[2].x, 1, 0);
    CHECK_TEXT(scene.primitives[1].text, "bed");
    CHECK(scene.primitives[0].starts[1] == 3);
    scene_clear(&scene);
    CHECK(scene.count == 0 && !scene.primitives);
}

TEST(every_role_can_be_read_in_both_themes) {
    static const Role texts[] = {ROLE_TEXT, ROLE_DIM_TEXT, ROLE_ROOM, ROLE_DOOR, ROLE_ERROR, ROLE_LOCUS};
    static const Role lines[] = {ROLE_WALL,        ROLE_FURNITURE_LINE, ROLE_CHAIR,  ROLE_RING,  ROLE_LOCUS_SECOND,
                                 ROLE_LOCUS_THIRD, ROLE_LOCUS_FOURTH,   ROLE_WALKER, ROLE_GHOST, ROLE_EXIT};
    static const Role tags[] = {ROLE_EXIT_TAG, ROLE_DANGER_LOW, ROLE_DANGER_MIDDLE, ROLE_DANGER_HIGH,
                                ROLE_CHAIR,    ROLE_ERROR,      ROLE_LOCUS_FOURTH};
    for (Theme theme = 0; theme < THEME_COUNT; theme++) {
        Colour paper = palette_colour(theme, ROLE_PAPER), band = palette_colour(theme, ROLE_BAND);
        CHECK(palette_contrast(band, palette_colour(theme, ROLE_GRID)) >= 1.4);
        CHECK(palette_contrast(palette_colour(theme, ROLE_LOCUS), band) >= 3);
        for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
            CHECK(palette_contrast(palette_colour(theme, texts[i]), paper) >= 4.5);
        CHECK(palette_contrast(palette_colour(theme, ROLE_IMPACT), palette_colour(theme, ROLE_PANEL)) >= 4.5);
        for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
            CHECK(palette_contrast(palette_colour(theme, lines[i]), paper) >= 3);
        for (size_t i = 0; i < sizeof tags / sizeof *tags; i++)
            CHECK(palette_contrast(palette_ink(theme, tags[i]), palette_colour(theme, tags[i])) >= 4.5);
    }
}

TEST(dangers_grow_darker_in_grey_on_paper) {
    Colour white = {1, 1, 1};
    double low = palette_contrast(palette_colour(THEME_PAPER, ROLE_DANGER_LOW), white);
    double middle = palette_contrast(palette_colour(THEME_PAPER, ROLE_DANGER_MIDDLE), white);
    double high = palette_contrast(palette_colour(THEME_PAPER, ROLE_DANGER_HIGH), white);
    CHECK(low < middle && middle < high);
}

TEST(letters_grow_in_proportion_to_their_size) {
    Vec2 once = text_extent("Out in 18.4 s", 20, true), twice = text_extent("Out in 18.4 s", 40, true);
    CHECK_NEAR(twice.x / once.x, 2, 0.01);
    CHECK_NEAR(twice.y / once.y, 2, 0.01);
}

TEST(no_words_overlap_or_leave_the_page) {
    static const Vec2 pages[] = {{1280, 720}, {1280, 800}, {1706, 720}, {1280, 2275}};
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        Scene scene = plain_scene();
        Layout layout;
        layout_make(&layout, &scene, pages[i]);
        check_words(&layout);
        layout_clear(&layout);
        scene_clear(&scene);
    }
}

TEST(long_words_are_shortened_and_a_long_detail_goes_below_the_answer) {
    Scene scene = plain_scene();
    char note[400];
    memset(note, 'n', sizeof note);
    note[sizeof note - 1] = 0;
    scene.note = note;
    scene.detail =
        "p4: cannot pass door d2, needs 0.79 m, has 0.75 m, after three contacts with the wardrobe and the wall";
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    check_words(&layout);
    CHECK(!captions_find(&layout, note));
    const Caption *title = captions_find(&layout, scene.title), *detail = captions_find(&layout, scene.detail);
    CHECK(title && detail && detail->centre.y > title->centre.y + title->extent.y / 2);
    layout_clear(&layout);
    scene_clear(&scene);
}

/* The remark of a house is cut behind a clause, never within a number or brackets. */
TEST(a_long_remark_ends_with_a_clause) {
    Scene scene = plain_scene();
    scene.note =
        "assumed plan: two streets, each of 6.25 m (of which 1.5 m are taken by benches, plants and much else that "
        "nobody has measured, and that could stand elsewhere), of A. Nobody";
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    CHECK(captions_find(&layout, "assumed plan: two streets \u2026"));
    layout_clear(&layout);
    scene.note =
        "assumed plan: a barrier-free house with a name that is far too long for one line of any picture at whatever "
        "size it is drawn with letters that can be read from the last row, since nobody could read it";
    layout_make(&layout, &scene, PAGE);
    CHECK(captions_find(&layout, "assumed plan \u2026"));
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(the_whole_plan_is_seen_undistorted) {
    Scene scene = plain_scene();
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    Vec2 low = layout_point(&layout, scene.box.low), high = layout_point(&layout, scene.box.high);
    CHECK(low.x >= layout.plan.low.x - 1e-9 && high.x <= layout.plan.high.x + 1e-9);
    CHECK(high.y >= layout.plan.low.y - 1e-9 && low.y <= layout.plan.high.y + 1e-9);
    CHECK_NEAR((high.x - low.x) / (low.y - high.y), 6.0 / 4, 1e-9);
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(a_long_corridor_has_its_list_below) {
    Scene scene = plain_scene();
    scene.box = (Box){{0, 0}, {40, 2}};
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    check_words(&layout);
    CHECK_NEAR(layout.list.low.x, 0, 0);
    CHECK_NEAR(layout.list.high.x, PAGE.x, 0);
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(labels_keep_off_lines_and_off_each_other) {
    Scene scene = plain_scene();
    Vec2 line[] = {{0, 2}, {6, 2}};
    scene_add_line(&scene, ROLE_LOCUS, 4, line, 2)->keep_clear = 2;
    for (int i = 0; i < 3; i++)
        scene_add_label(&scene, ROLE_TEXT, 17, vec2(3, 2), scene_text(&scene, "label %d", i));
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    check_words(&layout);
    double y = layout_point(&layout, line[0]).y;
    for (int i = 0; i < 3; i++) {
        const Caption *caption = captions_find(&layout, scene_text(&scene, "label %d", i));
        CHECK(caption != NULL);
        CHECK(caption && fabs(caption->centre.y - y) > caption->extent.y / 2 + 2);
    }
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(nothing_of_a_part_that_is_looked_at_lies_outside_the_frame) {
    Scene scene = plain_scene();
    scene.camera = (Camera){.kind = VIEW_RAISED, .azimuth = 10, .elevation = 60, .zoom = 3};
    for (int x = 0; x <= 6; x++)
        for (int y = 0; y <= 4; y++)
            scene_add_label(&scene, ROLE_TEXT, 17, vec2(x, y), scene_text(&scene, "#%d %d", x, y))->fixed = x % 2;
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    Box frame = box_expand(layout.frame, 1e-6);
    int seen = 0;
    for (size_t i = 0; i < layout.caption_count; i++) {
        Box box = caption_box(&layout.captions[i]);
        if (*layout.captions[i].text != '#')
            continue;
        CHECK(box_holds(frame, box.low) && box_holds(frame, box.high));
        seen++;
    }
    CHECK(seen > 2 && seen < 20);
    CHECK(layout.grid_count > 4);
    for (size_t i = 0; i < 2 * layout.grid_count; i++)
        CHECK(box_holds(frame, layout.grid[i]));
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(very_long_names_are_shortened) {
    enum { LETTERS = 90000 };
    char *name = memory_zeroed(LETTERS + 1, 1);
    memset(name, 'm', LETTERS);
    Scene scene = plain_scene();
    scene.name = name;
    scene_add_label(&scene, ROLE_TEXT, 17, vec2(1, 2), name);
    scene_add_label(&scene, ROLE_TEXT, 17, vec2(3, 3), name)->fixed = true;
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    int long_ones = 0;
    for (size_t i = 0; i < layout.caption_count; i++) {
        const Caption *caption = &layout.captions[i];
        Box box = caption_box(caption);
        if (*caption->text != 'm')
            continue;
        CHECK_TEXT(caption->text + strspn(caption->text, "m"), "\u2026");
        CHECK(box.low.x >= layout.frame.low.x && box.high.x <= layout.frame.high.x);
        long_ones++;
    }
    CHECK(long_ones == 3);
    layout_clear(&layout);
    scene_clear(&scene);
    memory_free(name);
}

TEST(a_fixed_label_at_the_upper_edge_leaves_the_house_s_name_readable) {
    Scene scene = plain_scene();
    Primitive *tag = scene_add_label(&scene, ROLE_TEXT, 17, vec2(0.5, 4), "EXIT e1: 25");
    scene_bind_label(&scene, tag, &(Vec2){0.5, 5}, 1);
    tag->fixed = true;
    Layout layout = {0};
    layout_make(&layout, &scene, PAGE);
    Box box = caption_box(captions_find(&layout, "EXIT e1: 25"));
    CHECK(!captions_overlap(box, caption_box(captions_find(&layout, "a house"))));
    CHECK(!captions_overlap(box, caption_box(captions_find(&layout, "assumed plan: not measured"))));
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(a_name_stays_inside_what_it_names_and_turns_when_it_must) {
    Scene scene = plain_scene();
    Vec2 wide[] = {{0.5, 0.5}, {2.5, 0.5}, {2.5, 1.5}, {0.5, 1.5}}, tall[] = {{4, 1}, {4.3, 1}, {4.3, 3}, {4, 3}};
    scene_bind_label(&scene, scene_add_label(&scene, ROLE_TEXT, 17, vec2(1.5, 1), "bed"), wide, 4);
    scene_bind_label(&scene, scene_add_label(&scene, ROLE_TEXT, 17, vec2(4.15, 2), "wardrobe"), tall, 4);
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    const Caption *bed = captions_find(&layout, "bed"), *wardrobe = captions_find(&layout, "wardrobe");
    CHECK(bed && !bed->turned);
    CHECK(wardrobe && wardrobe->turned);
    Box box = wardrobe ? caption_box(wardrobe) : (Box){0};
    CHECK(box.low.x >= layout_point(&layout, tall[0]).x && box.high.x <= layout_point(&layout, tall[1]).x);
    layout_clear(&layout);
    scene_clear(&scene);
}

/* Writes a picture to a temporary file and returns its bytes. */
static char *painted(const Scene *scene, CairoFileKind kind, size_t *size) {
    char path[CHECK_PATH];
    check_temporary(path, "scene-XXXXXX");
    int file = mkstemp(path);
    CHECK(file >= 0);
    close(file);
    CHECK(paint_cairo_file(kind, scene, path, 640, 360, THEME_PAPER) == 0);
    char *bytes = text_read_file(path, 1 << 24, size);
    unlink(path);
    return bytes;
}

TEST(the_same_scene_gives_the_same_bytes) {
    static const char *const beginnings[] = {
        [CAIRO_FILE_PNG] = "\x89PNG", [CAIRO_FILE_SVG] = "<?xml", [CAIRO_FILE_PDF] = "%PDF"};
    for (int i = 0; i < 3; i++) {
        Scene scene = plain_scene();
        scene_add_label(&scene, ROLE_TEXT, 17, vec2(1, 1), "bed");
        size_t first_size = 0, second_size = 1;
        char *first = painted(&scene, i, &first_size), *second = painted(&scene, i, &second_size);
        CHECK(first && second && first_size == second_size && memcmp(first, second, first_size) == 0);
        CHECK(first && memcmp(first, beginnings[i], strlen(beginnings[i])) == 0);
        memory_free(first);
        memory_free(second);
        scene_clear(&scene);
    }
}

TEST(a_picture_that_cannot_be_says_why) {
    Scene scene = plain_scene();
    CHECK(paint_cairo_file(CAIRO_FILE_PNG, &scene, "/tmp/clearance-never.png", 0, 720, THEME_PAPER) == EINVAL);
    CHECK(paint_cairo_file(CAIRO_FILE_SVG, &scene, "/tmp/clearance-never.svg", 1280, CAIRO_FILE_LARGEST + 1,
                           THEME_PAPER) == EINVAL);
    CHECK(paint_cairo_file(CAIRO_FILE_PNG, &scene, "/tmp/no-such-directory/a.png", 64, 36, THEME_PAPER) == ENOENT);
    CHECK(access("/tmp/clearance-never.png", F_OK) != 0);
    scene_clear(&scene);
}

TEST(codes_that_are_no_letters_do_no_harm) {
    char path[CHECK_PATH];
    check_temporary(path, "codes.pdf");
    Scene scene = plain_scene();
    scene.name = "a\x01\xef\xbf\xbf\xef\xb7\x90\xff";
    scene_add_label(&scene, ROLE_TEXT, 17, vec2(3, 2), scene.name);
    CHECK(paint_cairo_file(CAIRO_FILE_PDF, &scene, path, 1280, 720, THEME_PAPER) == 0);
    unlink(path);
    scene_clear(&scene);
}

static const Profile chair = {
    .name = "manual-chair", .length = 1.1, .width = 0.63, .axle = 0.35, .corner_radius = 0.06, .space_reach = 0.3};

TEST(a_silhouette_is_as_long_and_wide_as_the_body) {
    Vec2 outline[SILHOUETTE_POINTS];
    Box box = box_empty();
    silhouette_outline(&chair, vec2(2, 1), 0, 0, outline);
    for (int i = 0; i < SILHOUETTE_POINTS; i++)
        box = box_include(box, outline[i]);
    CHECK_NEAR(box.low.x, 2 - chair.axle, 1e-12);
    CHECK_NEAR(box.high.x, 2 - chair.axle + chair.length, 1e-12);
    CHECK_NEAR(box.high.y - box.low.y, chair.width, 1e-12);
    CHECK_NEAR(vec2_distance(silhouette_nearest(outline, vec2(2, 3)), vec2(2, 3)), 2 - chair.width / 2, 1e-12);
}

TEST(what_a_straight_way_sweeps_is_a_longer_body) {
    Vec2 first[SILHOUETTE_POINTS], second[SILHOUETTE_POINTS], hull[2 * SILHOUETTE_POINTS];
    silhouette_outline(&chair, vec2(0, 0), 0, 0, first);
    silhouette_outline(&chair, vec2(0.5, 0), 0, 0, second);
    size_t count = silhouette_hull(first, second, hull);
    double area[2] = {0};
    for (size_t i = 0; i < count; i++)
        area[1] += vec2_cross(hull[i], hull[(i + 1) % count]) / 2;
    for (int i = 0; i < SILHOUETTE_POINTS; i++)
        area[0] += vec2_cross(first[i], first[(i + 1) % SILHOUETTE_POINTS]) / 2;
    CHECK_NEAR(area[1] - area[0], 0.5 * chair.width, 1e-12);
}

/* One person in an empty house after the run that `person` describes. */
static Scene scene_after(PersonObservation person, const char *note) {
    static TraceColumn columns[TRACE_COLUMNS];
    Inhabitant inhabitant = {.id = "p1", .profile = &chair, .at = {1, 1}};
    House house = {.plan = {.name = "a house", .note = note}, .people = &inhabitant, .person_count = 1};
    house.outline = (Outline){.box = {{0, 0}, {6, 4}}, .broadphase = broadphase_create()};
    Observation observation = {
        .people = &person, .person_count = 1, .completed = person.completed, .time = person.time};
    trace_init(&observation.trace, columns, TRACE_COLUMNS);
    for (int i = 0; i <= 10 * person.time; i++)
        trace_add(&observation.trace,
                  (double[TRACE_COLUMNS]){[TRACE_TIME] = 0.1 * i, [TRACE_X] = 1 + 0.05 * i, [TRACE_Y] = 1});
    Scene scene;
    house_scene_make(&scene, &house, &observation);
    trace_clear(&observation.trace);
    outline_free(&house.outline);
    return scene;
}

TEST(somebody_who_is_out_is_the_answer) {
    Scene scene = scene_after(
        (PersonObservation){
            .took_part = true, .completed = true, .time = 8.04, .narrowest = 0.3, .narrowest_other = -1},
        "drawn from a measured plan");
    CHECK_TEXT(scene.title, "Out in 8.0 s");
    CHECK(scene.title_role == ROLE_TEXT);
    CHECK_TEXT(scene.detail, "no tight place");
    CHECK_TEXT(scene.note, "");
    scene_clear(&scene);
}

TEST(somebody_who_cannot_pass_is_told_where_and_by_how_much) {
    PersonObservation person = {.took_part = true,
                                .reason = REASON_CANNOT_PASS,
                                .blockage = {.at = {3, 2}, .what = "door d2", .has = 0.75, .needs = 0.79}};
    Scene scene = scene_after(person, "Assumed plan: not measured");
    CHECK_TEXT(scene.title, "A cannot pass door d2");
    CHECK_TEXT(scene.detail, "needs at least 0.79 m, has 0.75 m");
    CHECK(scene.title_role == ROLE_ERROR);
    CHECK_TEXT(scene.note, "Assumed plan: not measured");
    scene_clear(&scene);
}

TEST(a_locus_has_a_tick_each_second_and_a_number_each_fifth) {
    Scene scene = scene_after(
        (PersonObservation){.took_part = true, .completed = true, .time = 8, .narrowest = 0.3, .narrowest_other = -1},
        "");
    int ticks = 0, numbers = 0;
    for (size_t i = 0; i < scene.count; i++) {
        ticks += scene.primitives[i].kind == PRIMITIVE_TICK;
        numbers += strcmp(scene.primitives[i].text, "5 s") == 0;
    }
    CHECK_NEAR(ticks, 7, 0);
    CHECK_NEAR(numbers, 1, 0);
    scene_clear(&scene);
}

static const Profile adult = {
    .name = "adult", .driving = DRIVING_WALKER, .length = 0.38, .width = 0.38, .axle = 0.19, .space_reach = 0.15};

enum { MEMBERS = 40 };

/* A crowd of 40 and a chair before two exits: all have left except three who are blocked, two of them side by side,
 * and one whose time ran out. */
static Scene crowd_scene(Census *census, bool interrupted) {
    static TraceColumn columns[TRACE_COLUMNS];
    static char names[MEMBERS][24];
    Profile profiles[] = {chair, adult};
    Crowd crowd = {.id = "adults", .profile = "adult", .count = MEMBERS};
    Exit exits[] = {{.id = "e1", .from = {10, 1}, .to = {10, 2}, .closes = HUGE_VAL},
                    {.id = "e2", .from = {0, 1}, .to = {0, 2}, .closes = HUGE_VAL}};
    Inhabitant people[MEMBERS + 1];
    PersonObservation observed[MEMBERS + 1];
    House house = {.plan = {.name = "a hall", .note = "", .crowds = &crowd, .crowd_count = 1, .exits = exits},
                   .profiles = profiles,
                   .profile_count = 2,
                   .people = people,
                   .person_count = MEMBERS + 1};
    house.plan.exit_count = 2;
    house.outline.box = (Box){{0, 0}, {10, 6}};
    Observation observation = {.people = observed, .person_count = MEMBERS + 1, .time = 60, .interrupted = interrupted};
    trace_init(&observation.trace, columns, TRACE_COLUMNS);
    for (int i = 0; i <= MEMBERS; i++) {
        bool rides = i == MEMBERS;
        if (!rides)
            snprintf(names[i], sizeof names[i], "adults-%d", i + 1);
        people[i] =
            (Inhabitant){.id = rides ? "p1" : names[i], .profile = &profiles[!rides], .at = {0.2 + 0.2 * i, 1 + i % 4}};
        observed[i] = (PersonObservation){
            .took_part = true, .completed = true, .time = 10 + i, .exit = i % 4 == 0, .path_length = 6, .contacts = 1};
        for (int k = 0; k < 600; k++)
            trace_add(&observation.trace, (double[TRACE_COLUMNS]){[TRACE_TIME] = 0.1 * k,
                                                                  [TRACE_PERSON] = i,
                                                                  [TRACE_X] = people[i].at.x + 0.001 * k,
                                                                  [TRACE_Y] = people[i].at.y});
    }
    static const Blockage blockages[] = {{.at = {4, 1}, .what = "person adults-6", .has = 3, .needs = 0.76},
                                         {.at = {4.5, 1}, .what = "door d1", .has = 3, .needs = 0.38},
                                         {.at = {8, 5}, .what = "wall w", .has = 3, .needs = 0.38}};
    for (int i = 0; i < 3; i++) {
        observed[4 + i].completed = false;
        observed[4 + i].reason = REASON_BLOCKED;
        observed[4 + i].blockage = blockages[i];
    }
    observed[7].completed = false;
    observed[7].reason = REASON_TIME_LIMIT;
    Scene scene;
    house_scene_make(&scene, &house, &observation);
    *census = census_make(&house, &observation);
    trace_clear(&observation.trace);
    return scene;
}

static const Primitive *find_label(const Scene *scene, const char *text) {
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && strcmp(scene->primitives[i].text, text) == 0)
            return &scene->primitives[i];
    return NULL;
}

TEST(a_place_that_stops_several_is_told_once_with_the_widest_need) {
    static TraceColumn columns[TRACE_COLUMNS];
    enum { PEOPLE = 3 };
    static const double needs[PEOPLE] = {0.94, 0.95, 0.94};
    Inhabitant people[PEOPLE];
    PersonObservation observed[PEOPLE];
    House house = {.plan = {.name = "a house", .note = ""}, .people = people, .person_count = PEOPLE};
    house.outline = (Outline){.box = {{0, 0}, {6, 4}}, .broadphase = broadphase_create()};
    static char names[PEOPLE][16];
    for (int i = 0; i < PEOPLE; i++) {
        snprintf(names[i], sizeof names[i], "p%d", i + 1);
        people[i] = (Inhabitant){.id = names[i], .profile = &chair, .at = {1 + i, 1}};
        observed[i] = (PersonObservation){.took_part = true,
                                          .reason = REASON_CANNOT_PASS,
                                          .blockage = {.at = {3 + 0.01 * i, 2}, .what = "door d2", .has = 0.87}};
        observed[i].blockage.needs = needs[i];
    }
    Observation observation = {.people = observed, .person_count = PEOPLE};
    trace_init(&observation.trace, columns, TRACE_COLUMNS);
    Scene scene;
    house_scene_make(&scene, &house, &observation);
    CHECK_TEXT(scene.title, "Nobody gets out");
    CHECK_TEXT(scene.detail, "3 cannot pass door d2");
    size_t labels = 0;
    for (size_t i = 0; i < scene.count; i++)
        labels += scene.primitives[i].kind == PRIMITIVE_LABEL && strncmp(scene.primitives[i].text, "needs", 5) == 0;
    CHECK(labels == 1 && find_label(&scene, "needs at least 0.95 m, has 0.87 m"));
    scene_clear(&scene);
    trace_clear(&observation.trace);
    outline_free(&house.outline);
}

TEST(a_census_sums_crowds_and_puts_together_who_is_stopped_at_one_place) {
    Census census;
    Scene scene = crowd_scene(&census, false);
    CHECK(census.people == MEMBERS + 1 && census.out == MEMBERS - 3 && census.stuck == 4);
    CHECK(census.party_count == 2);
    CHECK_TEXT(census.parties[0].crowd->id, "adults");
    CHECK(!census.parties[1].crowd && census.parties[1].people == 1);
    CHECK(census.parties[0].people == MEMBERS && census.parties[0].out == MEMBERS - 4);
    CHECK_NEAR(census.parties[0].mean, (10 * 36 + MEMBERS * (MEMBERS - 1) / 2.0 - (4 + 5 + 6 + 7)) / 36, 1e-9);
    CHECK_NEAR(census.parties[0].last, 10 + MEMBERS - 1, 1e-9);
    CHECK(census.hold_count == 3 && census.holds[0].people == 2);
    CHECK_TEXT(census.holds[0].blockage.what, "door d1");
    CHECK(census.left[0] + census.left[1] == census.out);
    census_clear(&census);
    scene_clear(&scene);
}

TEST(a_picture_of_an_interrupted_run_does_not_say_that_people_are_not_out) {
    Census census;
    Scene scene = crowd_scene(&census, true);
    CHECK_TEXT(scene.title, "Interrupted at 60.0 s: of 41 people, 37 are out so far");
    CHECK_TEXT(scene.rows[scene.row_count - 1].cells[0], "still inside");
    census_clear(&census);
    scene_clear(&scene);
}

TEST(a_picture_of_a_crowd_names_nobody_and_counts_everybody) {
    Census census;
    Scene scene = crowd_scene(&census, false);
    CHECK_TEXT(scene.title, "4 of 41 are not out");
    CHECK_TEXT(
        scene.detail,
        "2 blocked at door d1, adults-7 blocked at wall w, adults-8 stopped by the time limit; the others are out "
        "in 50.0 s");
    CHECK(find_label(&scene, "2 blocked here") && find_label(&scene, "1 blocked here"));
    CHECK(!find_label(&scene, "adults-1") && !find_label(&scene, "p1"));
    CHECK(find_label(&scene, "EXIT e1: 27") && find_label(&scene, "EXIT e2: 10"));
    CHECK(census.left[0] == 27 && census.left[1] == 10);
    CHECK(scene.row_count == 4);
    CHECK_TEXT(scene.rows[1].cells[0], "wheelchair");
    CHECK(scene.rows[1].symbol == SYMBOL_BOX && scene.rows[1].role == ROLE_LOCUS);
    CHECK_TEXT(scene.rows[2].cells[0], "adult");
    CHECK_TEXT(scene.rows[2].cells[1], "36/40");
    CHECK(scene.rows[2].symbol == SYMBOL_DISC && scene.rows[2].role == ROLE_WALKER);
    CHECK_TEXT(scene.rows[3].cells[0], "not out");
    CHECK(scene.rows[3].symbol == SYMBOL_DIAMOND);
    census_clear(&census);
    scene_clear(&scene);
}

TEST(loci_of_a_crowd_are_thinned_but_end_where_they_end) {
    Census census;
    Scene scene = crowd_scene(&census, false);
    int loci = 0;
    for (size_t i = 0; i < scene.count; i++) {
        const Primitive *line = &scene.primitives[i];
        if (line->kind != PRIMITIVE_LINE || line->edge != ROLE_WALKER)
            continue;
        loci++;
        CHECK(line->count == 3 && line->edge_opacity < 0.5);
        CHECK_NEAR(line->points[2].x - line->points[0].x, 0.599, 1e-9);
    }
    CHECK_NEAR(loci, MEMBERS, 0);
    census_clear(&census);
    scene_clear(&scene);
}

TEST(a_close_label_is_left_out_where_it_finds_no_room) {
    Scene scene = plain_scene();
    Vec2 large[] = {{1, 1}, {3, 1}, {3, 2}, {1, 2}}, small[] = {{4, 1}, {4.1, 1}, {4.1, 1.1}, {4, 1.1}};
    Primitive *bed = scene_add_label(&scene, ROLE_TEXT, 17, vec2(2, 1.5), "bed");
    scene_bind_label(&scene, bed, large, 4);
    bed->close = true;
    Primitive *stool = scene_add_label(&scene, ROLE_TEXT, 17, vec2(4.05, 1.05), "stool");
    scene_bind_label(&scene, stool, small, 4);
    stool->close = true;
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    CHECK(captions_find(&layout, "bed") && !captions_find(&layout, "stool"));
    layout_clear(&layout);
    scene_clear(&scene);
}
