#include "check.h"

#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "stage.h"

enum { WIDTH = 1280, HEIGHT = 720 /* pixels, unit 1 */ };

#define EDGE 24   /* of 255: a smaller difference from the ground is the faint edge of a shape */
#define FACE 60   /* a larger difference is not a shadow */
#define COLOUR 2  /* of 255, between the painters */
#define PIXEL 1.0 /* between their edges */

/* Things to paint, each about (3, 2) --------------------------------------------------------------------------------*/

static const Scene GROUND = {.box = {{0, 0}, {6, 4}}};

static void add_convex(Scene *scene) {
    Primitive *polygon = scene_add_polygon(scene, ROLE_FURNITURE, (Vec2[]){{2, 1}, {4, 1.3}, {3.6, 3}, {2.2, 2.7}}, 4);
    polygon->edge = ROLE_FURNITURE_LINE;
    polygon->width = 2;
}

static void add_clockwise(Scene *scene) {
    scene_add_polygon(scene, ROLE_DOOR, (Vec2[]){{2.2, 2.7}, {3.6, 3}, {4, 1.3}, {2, 1}}, 4)->fill_opacity = 0.4;
}

static void add_concave(Scene *scene) {
    scene_add_polygon(scene, ROLE_WALL, (Vec2[]){{1, 1}, {5, 1}, {5, 3}, {3.5, 3}, {3.5, 1.5}, {1, 1.5}}, 6);
}

static void add_holed(Scene *scene) {
    Vec2 points[] = {{1, 1}, {5, 1}, {5, 3}, {1, 3}, {2, 1.5}, {2, 2.5}, {4, 2.5}, {4, 1.5}};
    scene_add_rings(scene, ROLE_WALL, points, (size_t[]){0, 4, 8}, 2)->width = 1.5;
}

static void add_crossing(Scene *scene) {
    scene_add_polygon(scene, ROLE_WALL, (Vec2[]){{2, 1}, {4, 3}, {4, 1}, {2, 3}}, 4);
}

static void add_united(Scene *scene) {
    Vec2 points[] = {{1, 1}, {3.5, 1}, {3.5, 2.5}, {1, 2.5}, {2.5, 1.5}, {5, 1.5}, {5, 3}, {2.5, 3}};
    Primitive *swept = scene_add_rings(scene, ROLE_LOCUS, points, (size_t[]){0, 4, 8}, 2);
    swept->united = true;
    swept->fill_opacity = 0.3;
}

static void add_hatched(Scene *scene) {
    Primitive *toppled = scene_add_polygon(scene, ROLE_FURNITURE, (Vec2[]){{2, 1}, {4, 1}, {4, 3}, {2, 3}}, 4);
    toppled->edge = ROLE_FURNITURE_LINE;
    toppled->width = 2;
    toppled->hatched = true;
}

static void add_bent(Scene *scene, LineStyle style, double width, double opacity) {
    Primitive *line = scene_add_line(scene, ROLE_LOCUS, width, (Vec2[]){{1, 1}, {3, 2}, {5, 2}, {5, 3}}, 4);
    line->style = style;
    line->edge_opacity = opacity;
}

static void add_solid_line(Scene *scene) {
    add_bent(scene, LINE_SOLID, 8, 1);
}

static void add_faint_line(Scene *scene) {
    add_bent(scene, LINE_SOLID, 16, 0.5);
}

static void add_dashed_line(Scene *scene) {
    add_bent(scene, LINE_DASHED, 4, 1);
}

static void add_dotted_line(Scene *scene) {
    add_bent(scene, LINE_DOTTED, 4, 1);
}

static void add_dash_dot_line(Scene *scene) {
    add_bent(scene, LINE_DASH_DOT, 4, 1);
}

static void add_disc(Scene *scene) {
    Primitive *disc = scene_add_discs(scene, ROLE_WALKER, 0.5, &(Vec2){3, 2}, 1);
    disc->edge = ROLE_WALL;
    disc->width = 3;
}

static void add_discs(Scene *scene) {
    Primitive *discs = scene_add_discs(scene, ROLE_CHAIR, 0.6, (Vec2[]){{2.6, 2}, {3.4, 2}}, 2);
    discs->fill_opacity = 0.3;
    discs->width = 2;
}

static void add_ring(Scene *scene) {
    Primitive *ring = scene_add_discs(scene, ROLE_RING, 0.8, &(Vec2){3, 2}, 1);
    ring->fill_opacity = 0;
    ring->edge_opacity = 0.75;
    ring->width = 3.5;
    ring->style = LINE_DASHED;
}

static void add_wheel(Scene *scene) {
    scene_add_wheel(scene, ROLE_TEXT, 0.3, vec2(2.8, 2), vec2(3.2, 2.1));
}

static void add_ball(Scene *scene) {
    scene_add_ball(scene, ROLE_WALKER, 0.4, vec2(3, 2));
}

static void add_tick(Scene *scene) {
    scene_add_tick(scene, ROLE_LOCUS, 4, 40, vec2(3, 2), vec2(4, 3));
}

static void add_dimension(Scene *scene) {
    scene_add_dimension(scene, ROLE_TEXT, 5, vec2(2, 1.5), vec2(4, 2.5));
}

static void add_short_dimension(Scene *scene) {
    scene_add_dimension(scene, ROLE_TEXT, 3, vec2(2.97, 2), vec2(3.03, 2));
}

static void add_tag(Scene *scene) {
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, 17, vec2(3, 2), "p-a");
    tag->shape = LABEL_TAG;
    tag->fill = ROLE_CHAIR;
    tag->fixed = true;
}

static void add_number(Scene *scene) {
    Primitive *disc = scene_add_label(scene, ROLE_TEXT, 17, vec2(3, 2), "1");
    disc->shape = LABEL_DISC;
    disc->fill = ROLE_DANGER_LOW;
    disc->fixed = disc->bold = true;
}

static void add_words(Scene *scene) {
    scene_add_polygon(scene, ROLE_WALL, (Vec2[]){{2, 1}, {4, 1}, {4, 3}, {2, 3}}, 4);
    scene_add_label(scene, ROLE_TEXT, 20, vec2(2, 2), "bathroom")->fixed = true;
}

typedef struct Sight {
    const char *name;
    void (*add)(Scene *scene);
    Vec2 middle; /* m, places where both painters' colours are compared */
    int reach;   /* pixels around it */
} Sight;

static const Sight sights[] = {
    {"convex polygon", add_convex, {3, 2}, 5},
    {"clockwise polygon", add_clockwise, {3, 2}, 5},
    {"concave polygon", add_concave, {4.2, 2}, 5},
    {"polygon with a hole", add_holed, {3, 2}, 5},
    {"polygon that crosses itself", add_crossing, {2.3, 2}, 5},
    {"united polygons", add_united, {3, 2}, 5},
    {"hatched polygon", add_hatched, {3, 2}, 40},
    {"line", add_solid_line, {4, 2}, 2},
    {"faint line's joint", add_faint_line, {3, 2}, 3},
    {"dashed line", add_dashed_line, {3, 2}, 60},
    {"dotted line", add_dotted_line, {3, 2}, 60},
    {"dash-dotted line", add_dash_dot_line, {3, 2}, 60},
    {"disc", add_disc, {3, 2}, 5},
    {"faint discs", add_discs, {3, 2}, 3},
    {"dashed ring", add_ring, {3, 2}, 5},
    {"wheel", add_wheel, {3, 2.05}, 5},
    {"ball", add_ball, {3, 2}, 5},
    {"tick", add_tick, {3, 2}, 0},
    {"dimension", add_dimension, {3, 2}, 1},
    {"short dimension", add_short_dimension, {3, 2}, 20},
    {"tag", add_tag, {3, 2}, 8},
    {"disc with a number", add_number, {3, 2}, 7},
    {"words", add_words, {2.5, 2.5}, 5},
};

static void check_sight(Stage *stage, const Sight *sight, Theme theme, bool moves) {
    Scene with = GROUND, still = GROUND, nothing = {0};
    int width = stage->picture.width, height = stage->picture.height;
    Picture ground = picture_make(width, height), cairo = picture_make(width, height);
    stage_show_by_cairo(&ground, &still, &nothing, theme);
    if (moves)
        with = (Scene){0};
    sight->add(&with);
    stage_show(stage, moves ? &still : &with, moves ? &with : &nothing);
    stage_show_by_cairo(&cairo, moves ? &still : &with, moves ? &with : &nothing, theme);
    Box gl = picture_changed(&stage->picture, &ground, EDGE), other = picture_changed(&cairo, &ground, EDGE);
    bool near =
        vec2_distance(gl.low, other.low) <= PIXEL * M_SQRT2 && vec2_distance(gl.high, other.high) <= PIXEL * M_SQRT2;
    double colours[2][3], unit = layout_unit(width, height);
    Layout layout;
    layout_make(&layout, &still, stage->page);
    Vec2 middle = vec2_scale(layout_point(&layout, sight->middle), unit);
    picture_mean(&stage->picture, middle, sight->reach, colours[0]);
    picture_mean(&cairo, middle, sight->reach, colours[1]);
    if (!near)
        printf("%s%s, unit %g: %g %g to %g %g, by cairo %g %g to %g %g\n", sight->name, moves ? " that moves" : "",
               unit, gl.low.x, gl.low.y, gl.high.x, gl.high.y, other.low.x, other.low.y, other.high.x, other.high.y);
    CHECK(near);
    for (int i = 0; i < 3; i++) {
        if (fabs(colours[0][i] - colours[1][i]) > COLOUR)
            printf("%s%s, unit %g, channel %d:\n", sight->name, moves ? " that moves" : "", unit, i);
        CHECK_NEAR(colours[0][i], colours[1][i], COLOUR);
    }
    layout_clear(&layout);
    scene_clear(&with);
    memory_free(ground.pixels);
    memory_free(cairo.pixels);
}

static void check_sights(int width, int height) {
    for (Theme theme = 0; theme < THEME_COUNT; theme++) {
        Stage stage = stage_begin(OFFSCREEN_ANY, width, height, theme);
        for (size_t i = 0; i < sizeof sights / sizeof *sights; i++)
            for (int moves = 0; moves < 2; moves++)
                check_sight(&stage, &sights[i], theme, moves);
        stage_end(&stage);
    }
}

TEST(both_painters_agree) {
    check_sights(WIDTH, HEIGHT);
}

LONG_TEST(both_painters_agree_on_large_pictures) {
    check_sights(WIDTH * 5 / 2, HEIGHT * 5 / 2);
}

/* Whole pictures ----------------------------------------------------------------------------------------------------*/

/* A scene with one of everything and text in every possible place. */
static Scene rich_scene(ViewKind view) {
    Scene scene = {.box = {{0, 0}, {6, 4}},
                   .grid = 1,
                   .top = 1,
                   .camera = {.kind = view, .azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION},
                   .title = "Out in 18.4 s",
                   .detail = "no contact",
                   .name = "a house",
                   .clock = "0 to 18.4 s"};
    for (size_t i = 0; i < sizeof sights / sizeof *sights; i++)
        sights[i].add(&scene);
    for (size_t i = 0; i < scene.count; i += 2)
        scene.primitives[i].height = 0.5;
    SceneRow *row = scene_add_row(&scene, ROW_LINE, "p-a");
    row->role = ROLE_LOCUS;
    row->width = 4;
    row->symbol = SYMBOL_DIAMOND;
    return scene;
}

static Picture picture_of(OffscreenKind kind, ViewKind view) {
    Stage stage = stage_begin(kind, WIDTH, HEIGHT, THEME_PAPER);
    Scene scene = rich_scene(view), nothing = {0};
    CHECK(offscreen_kind(stage.offscreen) == kind);
    stage_show(&stage, &scene, &nothing);
    scene_clear(&scene);
    Picture picture = stage.picture;
    stage.picture.pixels = NULL;
    stage_end(&stage);
    return picture;
}

static bool both_kinds(void) {
    char message[OFFSCREEN_MESSAGE];
    for (OffscreenKind kind = OFFSCREEN_OSMESA; kind <= OFFSCREEN_EGL; kind++) {
        Offscreen *offscreen = offscreen_create(kind, message);
        if (!offscreen) {
            printf("%s\n", message);
            return false;
        }
        offscreen_destroy(offscreen);
    }
    return true;
}

TEST(osmesa_and_egl_give_the_same_bytes) {
    for (ViewKind view = VIEW_PLAN; view <= VIEW_RAISED && both_kinds(); view++) {
        Picture osmesa = picture_of(OFFSCREEN_OSMESA, view), egl = picture_of(OFFSCREEN_EGL, view);
        CHECK(picture_equals(&osmesa, &egl));
        memory_free(osmesa.pixels);
        memory_free(egl.pixels);
    }
}

TEST(the_environment_chooses_the_renderer) {
    static const struct {
        const char *name;
        OffscreenKind kind; /* ANY: none */
    } choices[] = {{"osmesa", OFFSCREEN_OSMESA}, {"egl", OFFSCREEN_EGL}, {"vulkan", OFFSCREEN_ANY}};
    char message[OFFSCREEN_MESSAGE] = "", *before = getenv("CLEARANCE_GL");
    if (!both_kinds())
        return;
    for (size_t i = 0; i < sizeof choices / sizeof *choices; i++) {
        setenv("CLEARANCE_GL", choices[i].name, 1);
        Offscreen *offscreen = offscreen_create(OFFSCREEN_ANY, message);
        CHECK((offscreen ? offscreen_kind(offscreen) : OFFSCREEN_ANY) == choices[i].kind);
        if (offscreen)
            offscreen_destroy(offscreen);
    }
    CHECK(strstr(message, "osmesa or egl"));
    if (before)
        setenv("CLEARANCE_GL", before, 1);
    else
        unsetenv("CLEARANCE_GL");
}

TEST(an_empty_scene_is_paper) {
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_BOARD);
    Scene scene = GROUND, nothing = {0};
    scene.bare = true;
    stage_show(&stage, &scene, &nothing);
    Colour paper = palette_colour(THEME_BOARD, ROLE_PAPER);
    const unsigned char *corner = picture_at(&stage.picture, 3, 3);
    CHECK_NEAR(corner[0], 255 * paper.blue, 0.5);
    CHECK_NEAR(corner[2], 255 * paper.red, 0.5);
    CHECK(corner[3] == 255);
    stage_end(&stage);
}

TEST(nothing_is_seen_outside_the_frame) {
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_PAPER);
    Scene still = GROUND, nothing = {0}, moving = {0};
    still.title = "Out";
    still.detail = "";
    stage_show(&stage, &still, &nothing);
    Picture ground = stage.picture;
    stage.picture = picture_make(WIDTH, HEIGHT);
    scene_add_polygon(&moving, ROLE_WALL, (Vec2[]){{100, 100}, {200, 100}, {200, 200}}, 3)->width = 3;
    scene_add_line(&moving, ROLE_LOCUS, 4, (Vec2[]){{-50, 9}, {50, 9}}, 2);
    scene_add_discs(&moving, ROLE_WALKER, 1, (Vec2[]){{3, -1e4}, {1e5, 2}}, 2)->width = 2;
    stage_show(&stage, &still, &moving);
    CHECK(picture_equals(&stage.picture, &ground));
    memory_free(ground.pixels);
    scene_clear(&moving);
    stage_end(&stage);
}

TEST(a_picture_that_is_too_large_has_no_painter) {
    enum { TOO_LARGE = 1 << 20 /* pixels a side */ };
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_PAPER);
    const Gl *gl = offscreen_gl(stage.offscreen);
    CHECK(!paint_gl_create(gl, TOO_LARGE, TOO_LARGE, 1, THEME_PAPER));
    PaintGl *small = paint_gl_create(gl, 64, 36, layout_unit(64, 36), THEME_PAPER);
    CHECK(small);
    paint_gl_destroy(small);
    stage_end(&stage);
}

/* Layers ------------------------------------------------------------------------------------------------------------*/

TEST(what_is_added_stays) {
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_PAPER);
    Scene still = GROUND, more = {0}, nothing = {0};
    Layout under, over = {0}, empty = {0};
    add_solid_line(&more);
    layout_make(&under, &still, stage.page);
    layout_make_over(&over, &under, &more);
    layout_make_over(&empty, &under, &nothing);
    paint_gl_still(stage.paint, (Layer){&still, &under});
    paint_gl_add(stage.paint, (Layer){&more, &over});
    for (int frame = 0; frame < 2; frame++)
        paint_gl_frame(stage.paint, (Layer){&nothing, &empty});
    paint_gl_read(stage.paint, stage.picture.pixels);
    Colour locus = palette_colour(THEME_PAPER, ROLE_LOCUS);
    Vec2 at = layout_point(&under, vec2(4, 2));
    CHECK_NEAR(picture_at(&stage.picture, (int)at.x, (int)at.y)[0], 255 * locus.blue, 1);
    layout_clear(&under);
    layout_clear(&over);
    layout_clear(&empty);
    scene_clear(&more);
    stage_end(&stage);
}

TEST(a_panel_shows_what_has_changed) {
    enum { SIDE = 50, LEFT = 10, TOP = 20, PART = 30 };
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_PAPER);
    Scene still = GROUND, nothing = {0};
    still.panels = 2;
    stage_show(&stage, &still, &nothing);
    Picture ground = stage.picture;
    stage.picture = picture_make(WIDTH, HEIGHT);
    unsigned char pixels[SIDE * SIDE * 4];
    memset(pixels, 0x40, sizeof pixels);
    Layout layout, empty = {0};
    layout_make(&layout, &still, stage.page);
    layout_make_over(&empty, &layout, &nothing);
    paint_gl_panel(stage.paint, 1, pixels, SIDE, SIDE, SIDE * 4, LEFT, TOP, PART, SIDE); /* extends below it */
    paint_gl_frame(stage.paint, (Layer){&nothing, &empty});
    paint_gl_read(stage.paint, stage.picture.pixels);
    Box changed = picture_changed(&stage.picture, &ground, 0);
    Vec2 corner = layout.panels[1].low;
    CHECK_NEAR(changed.low.x, round(corner.x) + LEFT, 0);
    CHECK_NEAR(changed.low.y, round(corner.y) + TOP, 0);
    CHECK_NEAR(changed.high.x - changed.low.x, PART, 0);
    CHECK_NEAR(changed.high.y - changed.low.y, SIDE - TOP, 0);
    layout_clear(&layout);
    layout_clear(&empty);
    memory_free(ground.pixels);
    stage_end(&stage);
}

/* The raised view ---------------------------------------------------------------------------------------------------*/

static Scene raised_scene(void) {
    Scene scene = GROUND;
    scene.camera = (Camera){.kind = VIEW_RAISED, .azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION};
    scene.top = 1;
    return scene;
}

static const Vec2 block[] = {{2, 1}, {4, 1}, {4, 3}, {2, 3}};

static void check_corners(Stage *stage, const Scene *still, const Scene *moving, const Picture *ground) {
    Layout layout;
    layout_make(&layout, still, stage->page);
    stage_show(stage, still, moving);
    Box box = box_empty(), changed = picture_changed(&stage->picture, ground, FACE);
    for (int i = 0; i < 8; i++)
        box = box_include(box, layout_raised(&layout, block[i % 4], i < 4 ? 0.2 : 1));
    CHECK_NEAR(changed.low.x, box.low.x, 1.5);
    CHECK_NEAR(changed.low.y, box.low.y, 1.5);
    CHECK_NEAR(changed.high.x, box.high.x, 1.5);
    CHECK_NEAR(changed.high.y, box.high.y, 1.5);
    layout_clear(&layout);
}

TEST(a_prism_stands_where_the_layout_says) {
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_PAPER);
    Scene still = raised_scene(), with = raised_scene(), nothing = {0}, moving = {0};
    stage_show(&stage, &still, &nothing);
    Picture ground = stage.picture;
    stage.picture = picture_make(WIDTH, HEIGHT);
    Scene *const scenes[] = {&with, &moving};
    for (int i = 0; i < 2; i++) {
        Primitive *prism = scene_add_polygon(scenes[i], ROLE_CHAIR, block, 4);
        prism->base = 0.2;
        prism->height = 0.8;
    }
    check_corners(&stage, &with, &nothing, &ground);
    check_corners(&stage, &still, &moving, &ground);
    scene_clear(&with);
    scene_clear(&moving);
    memory_free(ground.pixels);
    stage_end(&stage);
}

TEST(a_wall_hides_what_is_behind_it) {
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_PAPER);
    Scene still = raised_scene(), moving = {0}, nothing = {0};
    scene_add_polygon(&still, ROLE_WALL, (Vec2[]){{1, 1}, {5, 1}, {5, 1.2}, {1, 1.2}}, 4)->height = 1;
    scene_add_discs(&moving, ROLE_DANGER_HIGH, 0.05, &(Vec2){3, 1.3}, 1); /* on the floor */
    scene_add_discs(&moving, ROLE_DANGER_HIGH, 0.05, &(Vec2){3, 1.3}, 1)->height = 0.2;
    scene_add_ball(&moving, ROLE_DANGER_HIGH, 0.05, vec2(3, 1.3))->base = 0.1;
    stage_show(&stage, &still, &nothing);
    Picture ground = stage.picture;
    stage.picture = picture_make(WIDTH, HEIGHT);
    stage_show(&stage, &still, &moving);
    CHECK(picture_equals(&stage.picture, &ground));
    scene_add_discs(&moving, ROLE_DANGER_HIGH, 0.05, &(Vec2){3, 0.9}, 1); /* before it */
    stage_show(&stage, &still, &moving);
    CHECK(!picture_equals(&stage.picture, &ground));
    memory_free(ground.pixels);
    scene_clear(&still);
    scene_clear(&moving);
    stage_end(&stage);
}

TEST(what_is_behind_the_camera_is_not_seen) {
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH, HEIGHT, THEME_PAPER);
    Scene still = raised_scene(), moving = {0}, nothing = {0};
    stage_show(&stage, &still, &nothing);
    Picture ground = stage.picture;
    stage.picture = picture_make(WIDTH, HEIGHT);
    scene_add_line(&moving, ROLE_LOCUS, 4, (Vec2[]){{3, -50}, {3, -60}}, 2);
    scene_add_polygon(&moving, ROLE_WALL, (Vec2[]){{2, -2}, {4, -2}, {3, -3}}, 3)->height = 50;
    scene_add_polygon(&moving, ROLE_WALL, block, 4)->fill_opacity = 0;
    moving.primitives[moving.count - 1].height = 1;
    scene_add_discs(&moving, ROLE_WALL, 0.2, &(Vec2){3, 2}, 1)->fill_opacity = 0;
    stage_show(&stage, &still, &moving);
    CHECK(picture_equals(&stage.picture, &ground));
    memory_free(ground.pixels);
    scene_clear(&moving);
    stage_end(&stage);
}

/* Long films --------------------------------------------------------------------------------------------------------*/

static size_t memory_used(void) {
    struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

/* A frame with text that no other frame has. */
static void show_number(Stage *stage, const Layout *under, int number) {
    Scene moving = {0};
    Layout over = {0};
    moving.clock = scene_text(&moving, "%.2f s", number / 30.0);
    for (int i = 0; i < 5; i++)
        scene_add_label(&moving, ROLE_TEXT, 17, vec2(1, i), scene_text(&moving, "person %d", 5 * number + i))->fixed =
            true;
    scene_add_discs(&moving, ROLE_CHAIR, 0.3, &(Vec2){number % 6, 2}, 1)->height = 1;
    layout_make_over(&over, under, &moving);
    paint_gl_frame(stage->paint, (Layer){&moving, &over});
    layout_clear(&over);
    scene_clear(&moving);
}

static void check_film(int frames, int first) {
    Stage stage = stage_begin(OFFSCREEN_ANY, WIDTH / 2, HEIGHT / 2, THEME_PAPER);
    Scene still = rich_scene(VIEW_RAISED);
    Layout under;
    layout_make(&under, &still, stage.page);
    paint_gl_still(stage.paint, (Layer){&still, &under});
    show_number(&stage, &under, 0);
    paint_gl_read(stage.paint, stage.picture.pixels);
    Picture begin = stage.picture;
    stage.picture = picture_make(begin.width, begin.height);
    size_t before = 0;
    for (int frame = 1; frame <= frames; frame++) {
        show_number(&stage, &under, frame);
        before = frame == first ? memory_used() : before;
    }
    /* the driver's own buffers vary; 1 kB per frame would exceed this */
    CHECK_NEAR((double)memory_used(), (double)before, 400e3);
    show_number(&stage, &under, 0);
    paint_gl_read(stage.paint, stage.picture.pixels);
    CHECK(picture_equals(&stage.picture, &begin));
    memory_free(begin.pixels);
    layout_clear(&under);
    scene_clear(&still);
    stage_end(&stage);
}

/* The text fills the atlas many times. */
LONG_TEST(a_long_film_takes_no_more_memory_and_its_words_stay_the_same) {
    check_film(1000, 300);
}
