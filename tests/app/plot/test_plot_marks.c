#include "check.h"

#include <cairo.h>
#include <string.h>

#include "base/memory.h"
#include "draw/caption.h"
#include "plot/plot_frame.h"
#include "plot/plot_layout.h"
#include "sample_plot.h"

TEST(a_quantity_is_shown_by_brightness_in_both_themes) {
    for (Theme theme = 0; theme < THEME_COUNT; theme++) {
        Colour paper = palette_colour(theme, ROLE_PAPER);
        double before = 0;
        for (int i = 0; i <= 20; i++) {
            double contrast = palette_contrast(palette_shade(theme, i / 20.0), paper);
            CHECK(contrast > before);
            before = theme == THEME_PAPER || i > 4 ? contrast : 0; /* the darkest are close to the board */
        }
    }
}

/* Returns the colour of a value, 0xRRGGBB. */
static unsigned colour_at(cairo_surface_t *surface, const PlotLayout *layout, Vec2 value) {
    Vec2 at = plot_frame_point(layout, value);
    const unsigned char *row =
        cairo_image_surface_get_data(surface) + (int)at.y * cairo_image_surface_get_stride(surface);
    const unsigned char *pixel = row + 4 * (int)at.x;
    return (unsigned)pixel[2] << 16 | (unsigned)pixel[1] << 8 | pixel[0];
}

static unsigned role_code(Role role) {
    Colour colour = palette_colour(THEME_PAPER, role);
    return (unsigned)lround(255 * colour.red) << 16 | (unsigned)lround(255 * colour.green) << 8 |
           (unsigned)lround(255 * colour.blue);
}

TEST(every_cell_of_a_map_has_the_colour_of_its_class_and_an_empty_one_none) {
    static const PlotClass classes[] = {{"period 1", "1", ROLE_CLASS_FIRST, PLOT_PATTERN_PLAIN},
                                        {"not periodic", "n", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN}};
    static const double values[] = {0, 1, NAN, 1, 0, 1};
    PlotRaster raster = {{{20, 0.1}, {320, 0.3}}, 3, 2, values, classes, 2, {.title = "period"}};
    Plot plot = {.x = {.title = "frequency", .unit = "Hz"}, .y = {.title = "clearance", .unit = "mm"}};
    plot.raster = &raster;
    PlotLayout layout;
    plot_layout_make(&layout, &plot, vec2(640, 400), PLOT_NAMES_BESIDE);
    cairo_surface_t *surface = sample_painted(&plot, 640, 400, 1);
    sample_check_layout(&layout);
    CHECK(sample_has_text(&layout, "period 1") && sample_has_text(&layout, "not periodic"));
    for (int i = 0; i < 6; i++) {
        Vec2 corner = vec2(20 + 100 * (i % 3 + 0.1), 0.1 + 0.1 * (i / 3 + 0.1)); /* away from glyphs */
        Role role = isnan(values[i]) ? ROLE_PAPER : classes[(int)values[i]].role;
        CHECK(colour_at(surface, &layout, corner) == role_code(role));
    }
    cairo_surface_destroy(surface);
    plot_layout_clear(&layout);
    size_t size;
    char *table = sample_written(&plot, SAMPLE_CSV, &size);
    CHECK_TEXT(table, "frequency [Hz],clearance [mm],period\r\n70,0.15,period 1\r\n170,0.15,not periodic\r\n"
                      "270,0.15,\r\n70,0.25,not periodic\r\n170,0.25,period 1\r\n270,0.25,not periodic\r\n");
    memory_free(table);
}

/* The marks of a class and of a series would be read as one where they cover each other. */
TEST(the_mark_of_a_class_keeps_off_the_signs_that_stand_on_it) {
    static const PlotClass classes[] = {{"period 1", "1", ROLE_CLASS_FIRST, PLOT_PATTERN_PLAIN}};
    static const double values[] = {0}, middle[] = {170, 0.2};
    PlotRaster raster = {{{20, 0.1}, {320, 0.3}}, 1, 1, values, classes, 1, {.title = "period"}};
    PlotSeries sign = {.name = "type I", .x = middle, .y = middle + 1, .count = 1};
    Plot plot = {.x = {.title = "frequency", .unit = "Hz"}, .y = {.title = "clearance", .unit = "mm"}};
    plot.raster = &raster;
    plot.series = &sign;
    plot.series_count = 1;
    sign.symbol = SYMBOL_DISC;
    sign.size = 12;
    PlotLayout layout;
    plot_layout_make(&layout, &plot, vec2(640, 400), PLOT_NAMES_ABOVE);
    Box taken = box_around(plot_frame_point(&layout, vec2(middle[0], middle[1])), sign.size / 2);
    size_t found = 0;
    for (size_t i = 0; i < layout.sheet.caption_count; i++) {
        const Caption *caption = &layout.sheet.captions[i];
        if (strcmp(caption->text, "1") != 0)
            continue;
        Box box = caption_box(caption);
        found++;
        CHECK(box.high.x <= taken.low.x || box.low.x >= taken.high.x || box.high.y <= taken.low.y ||
              box.low.y >= taken.high.y);
    }
    CHECK(found == 1);
    plot_layout_clear(&layout);
}

TEST(bands_and_areas_fill_what_lies_between_and_nothing_else) {
    double x[] = {0, 1, 2, 3, 4}, low[] = {1, 1, NAN, 1, 1}, high[] = {3, 3, NAN, 3, 3};
    PlotArea area = {"5 to 95 %", x, low, high, 5, ROLE_SHADE};
    PlotGuide guide = {.upright = true, .band = true, .at = 3.5, .to = HUGE_VAL, .role = ROLE_FURNITURE};
    Plot plot = sample_plot(NULL, 0);
    plot.areas = &area;
    plot.guides = &guide;
    plot.area_count = plot.guide_count = 1;
    plot.y.high = 4;
    PlotLayout layout;
    plot_layout_make(&layout, &plot, vec2(640, 400), PLOT_NAMES_BESIDE);
    cairo_surface_t *surface = sample_painted(&plot, 640, 400, 1);
    CHECK(colour_at(surface, &layout, vec2(0.53, 2.13)) == role_code(ROLE_SHADE));
    CHECK(colour_at(surface, &layout, vec2(3.37, 2.13)) == role_code(ROLE_SHADE));
    CHECK(colour_at(surface, &layout, vec2(0.53, 3.3)) == role_code(ROLE_PAPER));
    CHECK(colour_at(surface, &layout, vec2(2.13, 2.13)) == role_code(ROLE_PAPER));
    CHECK(colour_at(surface, &layout, vec2(3.77, 3.3)) == role_code(ROLE_FURNITURE));
    cairo_surface_destroy(surface);
    plot_layout_clear(&layout);
}

TEST(open_signs_are_hollow_and_stems_stand_on_the_foot) {
    double x[] = {1, 2, 3}, y[] = {1, 2, 3};
    PlotSeries series[] = {sample_line("stems", x, y, 3), sample_line("measured", x, y, 3)};
    series[0].stems = true;
    series[1].width = 0;
    series[1].symbol = SYMBOL_TRIANGLE;
    series[1].size = 14;
    series[1].open = true;
    Plot plot = sample_plot(series, 2);
    plot.x.high = plot.y.high = 4;
    PlotCanvas *canvas = plot_canvas_create(&plot, 400, 400, 1, THEME_PAPER);
    plot_canvas_advance(canvas, 1, 3);
    Vec2 middle = plot_canvas_place(canvas, vec2(2, 2));
    CHECK(sample_ink(canvas, middle) < 64 && sample_ink(canvas, vec2(middle.x, middle.y - 6)) > 128);
    plot_canvas_advance(canvas, 0, 3);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(3, 0.7))) > 128);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(2.47, 2.47))) < 64);
    plot_canvas_destroy(canvas);
}
