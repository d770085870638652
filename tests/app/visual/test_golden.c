/* Compares pictures with the reviewed ones in tests/golden, by tolerance, since other versions of Mesa, cairo or
 * pango round differently; the font is checked first, since another one changes everything. CLEARANCE_GOLDEN=write
 * in the environment writes the pictures: look at each one before committing it. */

#include <cairo.h>
#include <pango/pangocairo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "beam/beam_cycle.h"
#include "case.h"
#include "check.h"
#include "paint/offscreen.h"
#include "paint/paint_cairo.h"
#include "paint/paint_gl.h"
#include "plot/plate.h"
#include "paint/png.h"
#include "house/run.h"
#include "visual/beam/beam_film.h"
#include "visual/beam/beam_plots.h"
#include "visual/house/film.h"
#include "visual/house/house_scene.h"
#include "oscillator.h"

enum { WIDTH = 960, HEIGHT = 540 };

/* Of 255: smallest visible difference, and the largest fraction of pixels that may show it. */
enum { SEEN = 40 };
#define SHARE_MOST 0.002
#define MEAN_MOST 0.5

typedef struct Golden {
    const char *name; /* of the file */
    const char *house;
    const char *route; /* or NULL: all people */
    ViewKind view;
    Theme theme;
    double time; /* s; negative: the still picture by cairo */
    int shown;   /* FILM_... */
} Golden;

static const Golden goldens[] = {
    {"ube-plan", "ube-techno-house", "C", VIEW_PLAN, THEME_PAPER, 6, 0},
    {"ube-raised", "ube-techno-house", "C", VIEW_RAISED, THEME_BOARD, 6, 0},
    {"flat-raised", "flat-0.910-module", NULL, VIEW_RAISED, THEME_PAPER, 0, 0},
    {"meeting-raised", "two-chairs-corridor", NULL, VIEW_RAISED, THEME_PAPER, 7, FILM_CIRCLES},
    {"touch-plan", "corner-1.20-0.80", NULL, VIEW_PLAN, THEME_BOARD, 6.6, FILM_ROUTES | FILM_WIDTHS},
    {"bedroom-still", "bedroom-after-earthquake", NULL, VIEW_PLAN, THEME_PAPER, -1, 0},
};
enum { GOLDENS = sizeof goldens / sizeof *goldens };

static void paint_film(const Golden *golden, const House *house, const Observation *observation,
                       unsigned char *pixels) {
    char message[OFFSCREEN_MESSAGE];
    Offscreen *offscreen = offscreen_create(OFFSCREEN_ANY, message);
    CHECK(offscreen);
    if (!offscreen)
        return;
    FilmOptions options = {.camera = {golden->view, VIEW_AZIMUTH, VIEW_ELEVATION, 1}, .shown = golden->shown};
    Film *film = film_create(house, observation, &options);
    double unit = layout_unit(WIDTH, HEIGHT);
    Layout still, added = {0}, moving = {0};
    layout_make(&still, film_still(film), vec2(WIDTH / unit, HEIGHT / unit));
    film_show(film, golden->time);
    layout_make_over(&added, &still, film_added(film));
    layout_make_over(&moving, &still, film_moving(film));
    PaintGl *paint = paint_gl_create(offscreen_gl(offscreen), WIDTH, HEIGHT, layout_unit(WIDTH, HEIGHT), golden->theme);
    paint_gl_still(paint, (Layer){film_still(film), &still});
    paint_gl_add(paint, (Layer){film_added(film), &added});
    paint_gl_frame(paint, (Layer){film_moving(film), &moving});
    paint_gl_read(paint, pixels);
    paint_gl_destroy(paint);
    layout_clear(&still);
    layout_clear(&added);
    layout_clear(&moving);
    film_destroy(film);
    offscreen_destroy(offscreen);
}

static void paint_still(const Golden *golden, const House *house, const Observation *observation,
                        unsigned char *pixels) {
    Scene scene = {0};
    double unit = layout_unit(WIDTH, HEIGHT);
    house_scene_make(&scene, house, observation);
    cairo_surface_t *surface =
        cairo_image_surface_create_for_data(pixels, CAIRO_FORMAT_RGB24, WIDTH, HEIGHT, 4 * WIDTH);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, unit, unit);
    paint_cairo_scene(cairo, &scene, vec2(WIDTH / unit, HEIGHT / unit), golden->theme);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    scene_clear(&scene);
}

/* Returns the mean difference of a channel, of 255, and the fraction of visibly different pixels; 255 and 1 for
 * another size. */
static void compare(const unsigned char *pixels, cairo_surface_t *surface, double *mean, double *share) {
    *mean = 255;
    *share = 1;
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS || cairo_image_surface_get_width(surface) != WIDTH ||
        cairo_image_surface_get_height(surface) != HEIGHT)
        return;
    const unsigned char *kept = cairo_image_surface_get_data(surface);
    int stride = cairo_image_surface_get_stride(surface);
    double sum = 0, seen = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            int most = 0;
            for (int c = 0; c < 3; c++) {
                int difference = abs(pixels[4 * (y * WIDTH + x) + c] - kept[y * stride + 4 * x + c]);
                sum += difference;
                most = difference > most ? difference : most;
            }
            seen += most > SEEN;
        }
    *mean = sum / (3.0 * WIDTH * HEIGHT);
    *share = seen / (1.0 * WIDTH * HEIGHT);
}

/* Compares a picture with the golden one of that name, or writes it. */
static void check_picture(const char *name, const unsigned char *pixels) {
    char path[4096], made[4096];
    snprintf(path, sizeof path, "%s/tests/golden/%s.png", check_source(), name);
    const char *wish = getenv("CLEARANCE_GOLDEN");
    if (wish && strcmp(wish, "write") == 0)
        CHECK(png_write(path, pixels, WIDTH, HEIGHT) == 0);
    double mean, share;
    cairo_surface_t *kept = cairo_image_surface_create_from_png(path);
    compare(pixels, kept, &mean, &share);
    cairo_surface_destroy(kept);
    CHECK(mean <= MEAN_MOST && share <= SHARE_MOST);
    if (mean > MEAN_MOST || share > SHARE_MOST) {
        snprintf(made, sizeof made, "golden-%s.png", name);
        png_write(made, pixels, WIDTH, HEIGHT);
        printf("%s: differs by %.2f of 255, seen in %.2f %% of the picture; now it is %s\n", path, mean, 100 * share,
               made);
    }
}

static void paint_plot(const Plot *plot, unsigned char *pixels, Theme theme) {
    cairo_surface_t *surface =
        cairo_image_surface_create_for_data(pixels, CAIRO_FORMAT_RGB24, WIDTH, HEIGHT, 4 * WIDTH);
    cairo_t *cairo = cairo_create(surface);
    double unit = 2 * layout_unit(WIDTH, HEIGHT);
    cairo_scale(cairo, unit, unit);
    plot_paint(plot, cairo, vec2(WIDTH / unit, HEIGHT / unit), theme);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
}

static void check_golden(const Golden *golden) {
    static unsigned char pixels[4 * WIDTH * HEIGHT];
    House house;
    Observation observation;
    case_house(&house, golden->house, -1, golden->shown & FILM_WIDTHS ? case_touching : NULL);
    size_t route = golden->route ? plan_find_route(&house.plan, golden->route) : SIZE_MAX;
    run_house(&observation, &house, &(RunOptions){.route = route, .jobs = 1});
    if (golden->time >= 0)
        paint_film(golden, &house, &observation, pixels);
    else
        paint_still(golden, &house, &observation, pixels);
    observation_free(&observation);
    house_free(&house);
    check_picture(golden->name, pixels);
}

/* The phase plane of the shipped beam on a stable orbit: a chaotic one would amplify rounding. */
static void paint_phase(unsigned char *pixels) {
    Beam beam = {0};
    Rig rig;
    Response response;
    Fault fault = {0};
    char path[4096];
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", check_source());
    CHECK(beam_read(&beam, path, (const char *[]){"drive.frequency=190"}, 1, &fault));
    CHECK(rig_build(&rig, &beam, path, &fault));
    beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
    BeamPlots plots = beam_plots_make(&response, &beam, NULL, &(PlotChoice){{0}, 1});
    paint_plot(&plots.plots[0], pixels, THEME_BOARD);
    beam_plots_free(&plots);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

/* A map with all patterns, a key, a second axis and measured points. */
static void paint_map(unsigned char *pixels) {
    enum { COLUMNS = 24, ROWS = 16 };
    static const PlotClass classes[] = {{"no contact", "free", ROLE_CLASS_NONE, PLOT_PATTERN_PLAIN},
                                        {"period 1", "1", ROLE_CLASS_FIRST, PLOT_PATTERN_PLAIN},
                                        {"period 2", "2", ROLE_CLASS_SECOND, PLOT_PATTERN_RISING},
                                        {"period 3", "3", ROLE_CLASS_THIRD, PLOT_PATTERN_FALLING},
                                        {"period 4", "4", ROLE_CLASS_FOURTH, PLOT_PATTERN_CROSSED},
                                        {"5 to 8", "5", ROLE_CLASS_FIFTH, PLOT_PATTERN_UPRIGHT},
                                        {"9 and more", "9", ROLE_CLASS_SIXTH, PLOT_PATTERN_LEVEL},
                                        {"not periodic", "n", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN}};
    double values[COLUMNS * ROWS], x[] = {150, 190, 290}, y[] = {0.08, 0.1, 0.2};
    for (int i = 0; i < COLUMNS * ROWS; i++)
        values[i] = i % COLUMNS < 3 && i / COLUMNS > 12 ? NAN : (i % COLUMNS + i / COLUMNS) / 5;
    PlotRaster raster = {{{120, 0.02}, {320, 0.26}}, COLUMNS, ROWS, values, classes, 8, {.title = "period"}};
    PlotSeries measured = {
        .x = x, .y = y, .count = 3, .role = ROLE_IMPACT, .symbol = SYMBOL_TRIANGLE, .size = 11, .open = true};
    Plot plot = {.title = "Periods",
                 .x = {.title = "drive frequency", .unit = "Hz"},
                 .y = {.title = "joint clearance", .unit = "mm"},
                 .series = &measured,
                 .series_count = 1,
                 .raster = &raster,
                 .right = {.title = "g/a"},
                 .right_factor = 10};
    paint_plot(&plot, pixels, THEME_PAPER);
}

/* As `run` writes beam.png, but smaller. */
static void paint_beam(const char *setting, double time, Theme theme, unsigned char *pixels) {
    Beam beam = oscillator_beam("ibs", setting);
    Rig rig = oscillator_beam_rig("ibs", setting);
    Response response;
    BeamRecord record;
    beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
    beam_record_make(&record, &rig, &response);
    beam_record_sample(&record, (BeamSpan){0, 8 * rig.period, 1 / rig.period});
    BeamFilm *film = beam_film_create(&beam, &rig, &response, &record, 500);
    beam_film_show(film, time);
    beam_film_mark(film);
    Plate plate = {beam_film_still(film), beam_film_moving(film), beam_film_plots(film), theme};
    double unit = layout_unit(WIDTH, HEIGHT);
    cairo_surface_t *surface =
        cairo_image_surface_create_for_data(pixels, CAIRO_FORMAT_RGB24, WIDTH, HEIGHT, 4 * WIDTH);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, unit, unit);
    plate_paint(cairo, vec2(WIDTH / unit, HEIGHT / unit), &plate);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    beam_film_destroy(film);
    beam_record_clear(&record);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

TEST(the_letters_are_the_pinned_ones) {
    PangoContext *context = pango_font_map_create_context(pango_cairo_font_map_get_default());
    PangoFontDescription *wanted = pango_font_description_from_string("DejaVu Sans 12");
    PangoFont *font = pango_context_load_font(context, wanted);
    PangoFontDescription *got = pango_font_describe(font);
    CHECK_TEXT(pango_font_description_get_family(got), "DejaVu Sans");
    pango_font_description_free(got);
    g_object_unref(font);
    pango_font_description_free(wanted);
    g_object_unref(context);
}

TEST(pictures_are_as_they_were) {
    for (int i = 0; i < GOLDENS; i++)
        check_golden(&goldens[i]);
}

TEST(plots_are_as_they_were) {
    static unsigned char pixels[4 * WIDTH * HEIGHT];
    paint_phase(pixels);
    check_picture("beam-phase", pixels);
    paint_map(pixels);
    check_picture("periods-map", pixels);
}

/* A periodic motion, in which rounding stays invisible. */
TEST(a_beam_is_as_it_was) {
    static unsigned char pixels[4 * WIDTH * HEIGHT];
    paint_beam("drive.frequency=190", 0.0076, THEME_PAPER, pixels);
    check_picture("beam-190", pixels);
}
