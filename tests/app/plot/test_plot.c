#include "check.h"

#include <cairo.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/random.h"
#include "base/text.h"
#include "paint/cairo_file.h"
#include "plot/plot.h"
#include "plot/plot_canvas.h"
#include "plot/plot_frame.h"
#include "plot/plot_layout.h"
#include "plot/plot_write.h"

enum { MANY = 100000 };

static const Vec2 PAGES[] = {{384, 150}, {384, 300}, {640, 400}, {1280, 720}};

/* Returns a wave of `count` points over x from 0 to 10. */
static void fill_wave(double *x, double *y, size_t count) {
    for (size_t i = 0; i < count; i++) {
        x[i] = 10.0 * (double)i / (double)(count - 1);
        y[i] = 0.5 + 0.4 * sin(3 * x[i]) + 0.1 * sin(40 * x[i]);
    }
}

static PlotSeries line_of(const char *name, const double *x, const double *y, size_t count) {
    return (PlotSeries){.name = name, .x = x, .y = y, .count = count, .role = ROLE_LOCUS, .width = 3};
}

static Plot plot_of(PlotSeries *series, size_t count) {
    return (Plot){.x = {.title = "time", .unit = "s"},
                  .y = {.title = "clearance", .unit = "m"},
                  .series = series,
                  .series_count = count};
}

/* Ticks ------------------------------------------------------------------------------------------------------------ */

typedef struct Range {
    double low, high;
    int most;
} Range;

static const Range ranges[] = {{0, 1, 4},
                               {0, 18.4, 6},
                               {-0.3, 0.7, 5},
                               {-7, -2, 3},
                               {1e-9, 3.7e-9, 5},
                               {-2e12, 5.5e12, 6},
                               {0.31, 0.32, 2},
                               {0, 0, 5},
                               {42, 42, 5},
                               {-42, -42, 5},
                               {1e12, 1e12, 4},
                               {1e-9, 1e-9, 4},
                               {NAN, 1, 5},
                               {0, NAN, 5},
                               {-INFINITY, 3, 5},
                               {2, INFINITY, 5},
                               {INFINITY, -INFINITY, 5},
                               {1e9, 1e9 + 1e-3, 5},
                               {0, 1e300, 5},
                               {5e-324, 1e-320, 5},
                               {0, 1, 1},
                               {0, 100, 40},
                               {99.9999, 100.1, 7},
                               {3, 1, 5}};

static bool is_round(const PlotTicks *ticks) {
    return ticks->multiple == 1 || ticks->multiple == 2 || ticks->multiple == 5;
}

TEST(ticks_are_few_round_increasing_and_within_their_axis) {
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        for (int widened = 0; widened <= 1; widened++) {
            PlotTicks ticks = plot_ticks_make(ranges[i].low, ranges[i].high, ranges[i].most, widened);
            double slack = 1e-6 * (ticks.high - ticks.low);
            CHECK(is_round(&ticks));
            CHECK(isfinite(ticks.low) && isfinite(ticks.high) && ticks.low < ticks.high);
            CHECK(ticks.count <= (ranges[i].most > 2 ? ranges[i].most : 2) && ticks.count >= 1);
            for (int t = 0; t < ticks.count; t++) {
                double at = plot_ticks_at(&ticks, t);
                CHECK(at >= ticks.low - slack && at <= ticks.high + slack);
                CHECK(t == 0 || at > plot_ticks_at(&ticks, t - 1));
            }
        }
}

TEST(widened_axes_cover_what_they_show_and_no_more_than_a_step_beyond) {
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++) {
        double low = ranges[i].low, high = ranges[i].high;
        if (!(high > low) || !isfinite(low) || !isfinite(high) || high > 1e100 || high < 1e-100 ||
            high - low < 1e-6 * fabs(high))
            continue;
        PlotTicks ticks = plot_ticks_make(low, high, ranges[i].most, true);
        double step = ticks.multiple * pow(10, ticks.exponent), slack = 1e-8 * step;
        CHECK(ticks.low <= low + slack && ticks.high >= high - slack);
        CHECK(ticks.low > low - step && ticks.high < high + step);
    }
}

TEST(one_value_is_shown_from_nought_on) {
    PlotTicks above = plot_ticks_make(42, 42, 5, true), below = plot_ticks_make(-42, -42, 5, true);
    CHECK_NEAR(above.low, 0, 0);
    CHECK(above.high >= 42 && above.high <= 50);
    CHECK_NEAR(below.high, 0, 0);
    CHECK_NEAR(below.low, -above.high, 0);
}

TEST(labels_say_exactly_where_their_ticks_are) {
    static const struct {
        Range range;
        const char *labels; /* of all ticks */
        const char *title;
    } cases[] = {{{0, 1, 6}, "0 0.2 0.4 0.6 0.8 1.0", "force, N"},
                 {{-1, 1, 3}, "\u22121 0 1", "force, N"},
                 {{0, 30000, 4}, "0 10\u2009000 20\u2009000 30\u2009000", "force, N"},
                 {{0, 9000, 4}, "0 5000", "force, N"},
                 {{0, 3e6, 4}, "0 1 2 3", "force, 10\u2076 N"},
                 {{1.5e5, 2.5e5, 3}, "150 200 250", "force, 10\u00B3 N"},
                 {{0, 2e-9, 3}, "0 1 2", "force, 10\u207B\u2079 N"},
                 {{-4e12, 0, 3}, "\u22124 \u22122 0", "force, 10\u00B9\u00B2 N"},
                 {{0.05, 0.06, 3}, "0.050 0.055 0.060", "force, N"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        PlotTicks ticks = plot_ticks_make(cases[i].range.low, cases[i].range.high, cases[i].range.most, false);
        char all[512] = "", title[PLOT_TICKS_TITLE];
        for (int t = 0; t < ticks.count; t++) {
            char label[PLOT_TICKS_LABEL];
            plot_ticks_label(&ticks, t, label);
            strcat(strcat(all, t ? " " : ""), label);
        }
        CHECK_TEXT(all, cases[i].labels);
        plot_ticks_title(&ticks, "force", "N", title);
        CHECK_TEXT(title, cases[i].title);
    }
}

TEST(the_power_in_the_title_does_not_depend_on_the_number_of_ticks) {
    static const double highs[] = {60000, 99999, 100000, 5e-4, 9.99e-4, 7e8};
    for (size_t i = 0; i < sizeof highs / sizeof *highs; i++)
        for (int most = 2; most < 12; most++)
            CHECK(plot_ticks_make(0, highs[i], most, true).power == plot_ticks_make(0, highs[i], 20, true).power);
}

TEST(a_pure_number_has_no_unit) {
    PlotTicks plain = plot_ticks_make(0, 1, 5, true), large = plot_ticks_make(0, 1e6, 5, true);
    char title[PLOT_TICKS_TITLE];
    plot_ticks_title(&plain, "ratio", "1", title);
    CHECK_TEXT(title, "ratio");
    plot_ticks_title(&large, "count", NULL, title);
    CHECK_TEXT(title, "count, 10\u2076");
    plot_ticks_title(&plain, NULL, "m", title);
    CHECK_TEXT(title, "m");
}

TEST(logarithmic_ticks_are_powers_of_ten_or_one_two_and_five_of_them) {
    static const struct {
        double low, high;
        int most;
        bool widened;
        const char *labels;
    } cases[] = {{1, 1000, 6, true, "1 10 100 1000"},
                 {0.02, 7, 12, true, "0.02 0.05 0.1 0.2 0.5 1 2 5 10"},
                 {1e-6, 1, 4, false, "10\u207B\u2076 10\u207B\u2074 10\u207B\u00B2 10\u2070"},
                 {3, 400, 8, false, "5 10 20 50 100 200"},
                 {-1, NAN, 5, true, "0.1 0.2 0.5 1"},
                 {7, 7, 5, true, "5 10"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        PlotTicks ticks = plot_ticks_make_logarithmic(cases[i].low, cases[i].high, cases[i].most, cases[i].widened);
        char all[512] = "";
        for (int t = 0; t < ticks.count; t++) {
            char label[PLOT_TICKS_LABEL];
            plot_ticks_label(&ticks, t, label);
            strcat(strcat(all, t ? " " : ""), label);
            double part = plot_ticks_part(&ticks, plot_ticks_at(&ticks, t));
            CHECK(part > -1e-9 && part < 1 + 1e-9);
        }
        CHECK_TEXT(all, cases[i].labels);
        CHECK(ticks.low < ticks.high);
    }
}

TEST(equal_ratios_are_equally_far_apart_on_a_logarithmic_axis) {
    PlotTicks ticks = plot_ticks_make_logarithmic(1e-3, 1e3, 7, true);
    CHECK_NEAR(plot_ticks_part(&ticks, 1), 0.5, 1e-12);
    CHECK_NEAR(plot_ticks_part(&ticks, 20) - plot_ticks_part(&ticks, 2), 1.0 / 6, 1e-12);
    CHECK(plot_ticks_part(&ticks, 0) < -1e9 && plot_ticks_part(&ticks, -1) < -1e9);
}

/* Layout ----------------------------------------------------------------------------------------------------------- */

static Box caption_box(const Caption *caption) {
    Vec2 half = vec2_scale(caption->extent, 0.5);
    return (Box){vec2_sub(caption->centre, half), vec2_add(caption->centre, half)};
}

/* Texts keep apart by their glyphs: the upper and lower edges of the boxes are empty. */
static bool words_overlap(const Caption *a, const Caption *b) {
    const double empty = 0.1;
    Box first = caption_box(a), second = caption_box(b);
    first = (Box){{first.low.x, first.low.y + empty * a->size}, {first.high.x, first.high.y - empty * a->size}};
    second = (Box){{second.low.x, second.low.y + empty * b->size}, {second.high.x, second.high.y - empty * b->size}};
    return first.low.x < second.high.x && second.low.x < first.high.x && first.low.y < second.high.y &&
           second.low.y < first.high.y;
}

static void check_layout(const PlotLayout *layout) {
    const Layout *sheet = &layout->sheet;
    CHECK(sheet->frame.high.y - sheet->frame.low.y >= 0.4 * sheet->page.y);
    for (size_t i = 0; i < sheet->caption_count; i++) {
        Box box = caption_box(&sheet->captions[i]);
        CHECK(box.low.x >= 0 && box.low.y >= 0 && box.high.x <= sheet->page.x && box.high.y <= sheet->page.y);
        CHECK(sheet->captions[i].size >= LAYOUT_SMALLEST_TEXT);
        for (size_t j = i + 1; j < sheet->caption_count; j++)
            CHECK(!words_overlap(&sheet->captions[i], &sheet->captions[j]));
    }
}

static bool has_words(const PlotLayout *layout, const char *text) {
    for (size_t i = 0; i < layout->sheet.caption_count; i++)
        if (strcmp(layout->sheet.captions[i].text, text) == 0)
            return true;
    return false;
}

TEST(no_words_overlap_or_leave_the_page_whatever_the_numbers) {
    static const Range values[] = {{0, 1, 0},        {-1234, 98765, 0},  {1e-9, 2e-9, 0},  {-1e12, 1e12, 0},
                                   {0.1, 0.1, 0},    {-5, -5, 0},        {0, 12345, 0},    {NAN, NAN, 0},
                                   {INFINITY, 1, 0}, {99999, 100001, 0}, {1e9, 1e9 + 1, 0}};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        for (size_t p = 0; p < sizeof PAGES / sizeof *PAGES; p++) {
            double numbers[] = {values[i].low, values[i].high}, turned[] = {values[i].high, values[i].low};
            double plain[] = {0, 1};
            PlotSeries series[] = {line_of("before", numbers, numbers, 2), line_of("p1", numbers, turned, 2)};
            if (p % 2)
                series[0].y = series[1].y = plain;
            PlotGuide guide = {.at = values[i].high, .name = "danger below", .role = ROLE_ERROR};
            Plot plot = plot_of(series, 2);
            plot.note = "6 of 40 people";
            plot.guides = &guide;
            plot.guide_count = 1;
            for (PlotNames names = PLOT_NAMES_BESIDE; names <= PLOT_NAMES_ABOVE; names++) {
                PlotLayout layout;
                plot_layout_make(&layout, &plot, PAGES[p], names);
                check_layout(&layout);
                plot_layout_clear(&layout);
            }
        }
}

TEST(names_stand_at_lines_that_are_apart_and_above_lines_that_are_not) {
    double x[100], low[100], high[100];
    fill_wave(x, low, 100);
    for (int i = 0; i < 100; i++)
        high[i] = low[i] + 2;
    PlotSeries apart[] = {line_of("low", x, low, 100), line_of("high", x, high, 100)};
    PlotSeries same[] = {line_of("low", x, low, 100), line_of("high", x, low, 100)};
    for (size_t p = 1; p < sizeof PAGES / sizeof *PAGES; p++) {
        Plot first = plot_of(apart, 2), second = plot_of(same, 2);
        PlotLayout beside, above;
        plot_layout_make(&beside, &first, PAGES[p], PLOT_NAMES_BESIDE);
        plot_layout_make(&above, &second, PAGES[p], PLOT_NAMES_BESIDE);
        CHECK(beside.sheet.sample_count == 0 && has_words(&beside, "low") && has_words(&beside, "high"));
        CHECK(above.sheet.sample_count == 2 && has_words(&above, "low") && has_words(&above, "high"));
        plot_layout_clear(&beside);
        plot_layout_clear(&above);
    }
}

TEST(many_long_names_leave_the_plot_its_height) {
    double x[] = {0, 1}, y[] = {0, 1};
    PlotSeries series[6];
    for (int i = 0; i < 6; i++)
        series[i] = line_of("somebody with quite a long name", x, y, 2);
    Plot plot = plot_of(series, 6);
    for (size_t p = 0; p < sizeof PAGES / sizeof *PAGES; p++) {
        PlotLayout layout;
        plot_layout_make(&layout, &plot, PAGES[p], PLOT_NAMES_ABOVE);
        check_layout(&layout);
        CHECK(has_words(&layout, series[0].name) == (PAGES[p].y > 300));
        plot_layout_clear(&layout);
    }
}

TEST(an_empty_plot_has_axes) {
    PlotSeries none = line_of("none", NULL, NULL, 0);
    Plot plots[] = {plot_of(NULL, 0), plot_of(&none, 1)};
    for (int i = 0; i < 2; i++) {
        PlotLayout layout;
        plot_layout_make(&layout, &plots[i], PAGES[0], PLOT_NAMES_BESIDE);
        CHECK_NEAR(layout.x.low, 0, 0);
        CHECK_NEAR(layout.x.high, 1, 0);
        CHECK(layout.x.count >= 2 && layout.y.count >= 2);
        plot_layout_clear(&layout);
        PlotCanvas *canvas = plot_canvas_create(&plots[i], 384, 150, 1, THEME_PAPER);
        plot_canvas_restart(canvas);
        plot_canvas_destroy(canvas);
    }
}

TEST(a_given_axis_is_kept_to_the_digit) {
    double x[] = {0, 10}, y[] = {-3, 7};
    PlotSeries series = line_of("p1", x, y, 2);
    Plot plot = plot_of(&series, 1);
    plot.x.low = 1.3;
    plot.x.high = 2.7;
    PlotLayout layout;
    plot_layout_make(&layout, &plot, PAGES[1], PLOT_NAMES_BESIDE);
    CHECK_NEAR(plot_frame_point(&layout, vec2(1.3, 0)).x, layout.sheet.frame.low.x, 1e-9);
    CHECK_NEAR(plot_frame_point(&layout, vec2(2.7, 0)).x, layout.sheet.frame.high.x, 1e-9);
    plot_layout_clear(&layout);
}

/* Canvas ----------------------------------------------------------------------------------------------------------- */

/* Differences of two pictures of equal size: of 255, in any channel. */
typedef struct Difference {
    int most;
    double mean; /* over all pixels and channels */
} Difference;

static Difference difference(const unsigned char *a, const unsigned char *b, int stride, int width, int height) {
    Difference result = {0};
    for (int y = 0; y < height; y++)
        for (int x = 0; x < 4 * width; x++)
            if (x % 4 < 3) {
                int apart = abs(a[y * stride + x] - b[y * stride + x]);
                result.most = apart > result.most ? apart : result.most;
                result.mean += apart / (3.0 * width * height);
            }
    return result;
}

/* Advances by steps of varying length. */
static void advance_in_steps(PlotCanvas *canvas, size_t series, size_t count, int most, uint64_t seed) {
    Random random = random_seed(seed, 0);
    for (size_t done = 0; done < count;) {
        done += 1 + (size_t)(random_uniform(&random) * most);
        plot_canvas_advance(canvas, series, done < count ? done : count);
    }
}

/* Paints at once, like plot_paint. */
static cairo_surface_t *painted_whole(const Plot *plot, int width, int height, double unit) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, unit, unit);
    plot_paint(plot, cairo, vec2(width / unit, height / unit), THEME_PAPER);
    cairo_destroy(cairo);
    cairo_surface_flush(surface);
    return surface;
}

/* Compares a canvas advanced by at most `most` points per step with the same plot painted at once. */
static void check_bit_by_bit(Plot *plot, int most) {
    enum { WIDTH = 576, HEIGHT = 225 };
    PlotGuide guide = {.at = 0.4, .name = "danger below", .role = ROLE_ERROR, .style = LINE_DASHED};
    plot->guides = &guide;
    plot->guide_count = 1;
    cairo_surface_t *whole = painted_whole(plot, WIDTH, HEIGHT, 1.5);
    PlotCanvas *canvas = plot_canvas_create(plot, WIDTH, HEIGHT, 1.5, THEME_PAPER);
    advance_in_steps(canvas, 0, plot->series->count, most, (uint64_t)most);
    CHECK(plot_canvas_stride(canvas) == cairo_image_surface_get_stride(whole));
    Difference apart = difference(plot_canvas_pixels(canvas), cairo_image_surface_get_data(whole),
                                  plot_canvas_stride(canvas), WIDTH, HEIGHT);
    CHECK(apart.most <= 128);
    CHECK_NEAR(apart.mean, 0, 0.1);
    plot_canvas_destroy(canvas);
    cairo_surface_destroy(whole);
}

/* Where two separately drawn parts of a line share a pixel, the pixel has the ink of the part that covers more of
 * it, at least half of the total coverage: hence 128 of 255 for single pixels. Ink over ink differs by 0.4 on
 * average. */
TEST(a_line_drawn_bit_by_bit_is_the_line_drawn_at_once) {
    enum { COUNT = 3000 };
    static double x[COUNT], y[COUNT];
    for (LineStyle style = LINE_SOLID; style < LINE_STYLES; style++)
        for (int most = 1; most < COUNT; most *= 20) {
            fill_wave(x, y, COUNT);
            y[1200] = y[1500] = NAN;
            PlotSeries series = line_of("p1", x, y, COUNT);
            series.style = style;
            Plot plot = plot_of(&series, 1);
            check_bit_by_bit(&plot, most);
        }
}

TEST(points_drawn_bit_by_bit_are_the_points_drawn_at_once) {
    enum { COUNT = 500 };
    static double x[COUNT], y[COUNT];
    fill_wave(x, y, COUNT);
    for (Symbol symbol = SYMBOL_DISC; symbol < SYMBOLS; symbol++) {
        PlotSeries series = {.x = x, .y = y, .count = COUNT, .role = ROLE_LOCUS, .symbol = symbol, .size = 4};
        Plot plot = plot_of(&series, 1);
        check_bit_by_bit(&plot, 40);
    }
}

static unsigned char *copy_pixels(const PlotCanvas *canvas, int height) {
    size_t size = (size_t)height * (size_t)plot_canvas_stride(canvas);
    return memcpy(memory_zeroed(size, 1), plot_canvas_pixels(canvas), size);
}

TEST(only_the_returned_pixels_change_and_a_restart_takes_all_back) {
    enum { COUNT = 400, WIDTH = 384, HEIGHT = 150 };
    static double x[COUNT], y[COUNT];
    fill_wave(x, y, COUNT);
    PlotSeries series[] = {line_of("p1", x, y, COUNT), line_of("p2", y, x, COUNT)};
    series[1].symbol = SYMBOL_DISC;
    series[1].size = 7;
    Plot plot = plot_of(series, 2);
    PlotCanvas *canvas = plot_canvas_create(&plot, WIDTH, HEIGHT, 1, THEME_BOARD);
    unsigned char *ground = copy_pixels(canvas, HEIGHT);
    int stride = plot_canvas_stride(canvas);
    for (size_t done = 10; done <= COUNT; done += 10)
        for (size_t s = 0; s < 2; s++) {
            unsigned char *before = copy_pixels(canvas, HEIGHT);
            PlotPixels changed = plot_canvas_advance(canvas, s, done);
            CHECK(changed.width > 0 && changed.x >= 0 && changed.x + changed.width <= WIDTH);
            CHECK(changed.height > 0 && changed.y >= 0 && changed.y + changed.height <= HEIGHT);
            for (int row = changed.y; row < changed.y + changed.height; row++)
                memcpy(before + row * stride + 4 * changed.x, plot_canvas_pixels(canvas) + row * stride + 4 * changed.x,
                       4 * (size_t)changed.width);
            CHECK(difference(before, plot_canvas_pixels(canvas), stride, WIDTH, HEIGHT).most == 0);
            memory_free(before);
        }
    CHECK(difference(ground, plot_canvas_pixels(canvas), stride, WIDTH, HEIGHT).most > 0);
    CHECK(plot_canvas_advance(canvas, 0, COUNT - 50).width == 0);
    plot_canvas_restart(canvas);
    CHECK(difference(ground, plot_canvas_pixels(canvas), stride, WIDTH, HEIGHT).most == 0);
    memory_free(ground);
    plot_canvas_destroy(canvas);
}

/* Returns the difference of a pixel from the paper, of 255. */
static int ink_at(const PlotCanvas *canvas, Vec2 place) {
    const unsigned char *pixel =
        plot_canvas_pixels(canvas) + (int)place.y * plot_canvas_stride(canvas) + 4 * (int)place.x;
    return 255 - pixel[2];
}

TEST(one_point_of_many_that_stands_out_is_seen) {
    static double x[MANY], y[MANY];
    for (size_t i = 0; i < MANY; i++) {
        x[i] = (double)i;
        y[i] = 0.01 * (double)(i % 7);
    }
    static const size_t spikes[] = {3, 31415, 31416 + 250, 77777, MANY - 2};
    for (size_t s = 0; s < 5; s++)
        y[spikes[s]] = s % 2 ? -1 : 1;
    PlotSeries series = line_of("p1", x, y, MANY);
    Plot plot = plot_of(&series, 1);
    PlotCanvas *canvas = plot_canvas_create(&plot, 384, 150, 1, THEME_PAPER);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(31415, -0.5))) < 64);
    plot_canvas_advance(canvas, 0, MANY);
    for (size_t s = 0; s < 5; s++)
        CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(x[spikes[s]], 0.95 * y[spikes[s]]))) > 128);
    plot_canvas_destroy(canvas);
}

TEST(a_series_may_grow_and_move_while_it_is_drawn) {
    double first[] = {0, 1, 2}, longer[] = {0, 1, 2, 3, 4, 5};
    PlotSeries series = line_of("p1", first, first, 3);
    Plot plot = plot_of(&series, 1);
    plot.x.high = plot.y.high = 5;
    PlotCanvas *canvas = plot_canvas_create(&plot, 300, 300, 1, THEME_PAPER);
    plot_canvas_advance(canvas, 0, 3);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(3.6, 3.6))) < 64);
    series.x = series.y = longer;
    series.count = 6;
    plot_canvas_advance(canvas, 0, 6);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(1.6, 1.6))) > 128);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(3.6, 3.6))) > 128);
    plot_canvas_destroy(canvas);
}

TEST(what_is_no_number_breaks_the_line_and_a_single_point_is_a_dot) {
    double x[] = {0, 1, 2, 3, 4, 5, 6}, y[] = {1, 1, NAN, 1, INFINITY, 1, 1};
    PlotSeries series = line_of("p1", x, y, 7);
    Plot plot = plot_of(&series, 1);
    plot.y.high = 2;
    PlotCanvas *canvas = plot_canvas_create(&plot, 384, 150, 1, THEME_PAPER);
    plot_canvas_advance(canvas, 0, 7);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(0.5, 1))) > 128);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(2.5, 1))) < 64);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(3, 1))) > 128);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(4.5, 1))) < 64);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(5.5, 1))) > 128);
    plot_canvas_destroy(canvas);
}

/* Files ------------------------------------------------------------------------------------------------------------ */

enum { CSV = CAIRO_FILE_PDF + 1 /* alongside CairoFileKind */ };

/* Writes a picture of 800 x 500, or a table, under /tmp and returns its bytes, ended by 0. */
static char *written(const Plot *plot, int kind, size_t *size) {
    char path[] = "/tmp/clearance-plot-XXXXXX";
    int file = mkstemp(path);
    CHECK(file >= 0);
    close(file);
    CHECK((kind == CSV ? plot_write_csv(plot, path)
                       : plot_write_picture((CairoFileKind)kind, plot, path, 800, 500, THEME_PAPER)) == 0);
    char *bytes = text_read_file(path, 1 << 26, size);
    unlink(path);
    return bytes;
}

TEST(the_same_plot_gives_the_same_bytes) {
    static const char *const beginnings[] = {
        [CAIRO_FILE_PNG] = "\x89PNG", [CAIRO_FILE_SVG] = "<?xml", [CAIRO_FILE_PDF] = "%PDF"};
    double x[200], y[200];
    fill_wave(x, y, 200);
    PlotSeries series[] = {line_of("p1", x, y, 200), line_of("p2", y, x, 200)};
    Plot plot = plot_of(series, 2);
    for (int i = CAIRO_FILE_PNG; i <= CAIRO_FILE_PDF; i++) {
        size_t first_size = 0, second_size = 1;
        char *first = written(&plot, i, &first_size);
        sleep(i == CAIRO_FILE_PDF); /* a date would change the bytes */
        char *second = written(&plot, i, &second_size);
        CHECK(first && second && first_size == second_size && memcmp(first, second, first_size) == 0);
        CHECK(first && memcmp(first, beginnings[i], strlen(beginnings[i])) == 0);
        memory_free(first);
        memory_free(second);
    }
}

TEST(a_plot_that_cannot_be_written_says_why) {
    Plot plot = plot_of(NULL, 0);
    CHECK(plot_write_picture(CAIRO_FILE_PNG, &plot, "/tmp/clearance-never.png", 0, 100, THEME_PAPER) == EINVAL);
    CHECK(plot_write_picture(CAIRO_FILE_PDF, &plot, "/tmp/clearance-never.pdf", 100, CAIRO_FILE_LARGEST + 1,
                             THEME_PAPER) == EINVAL);
    CHECK(plot_write_picture(CAIRO_FILE_SVG, &plot, "/tmp/no-such-directory/a.svg", 100, 100, THEME_PAPER) == ENOENT);
    CHECK(plot_write_csv(&plot, "/tmp/no-such-directory/a.csv") == ENOENT);
    CHECK(access("/tmp/clearance-never.png", F_OK) != 0);
}

TEST(a_table_has_two_columns_a_series_and_names_them) {
    double rows[][3] = {{0, 7, 0.1}, {1, 7, NAN}, {2.5, 7, 1e-12}}, x[] = {-1}, y[] = {1234567.25};
    PlotSeries series[] = {line_of("p1", &rows[0][0], &rows[0][2], 3), line_of("a \"b\", c", x, y, 1)};
    series[0].stride = 3;
    series[1].heading = series[1].name;
    series[1].name = NULL;
    Plot plot = plot_of(series, 2);
    size_t size;
    char *two = written(&plot, CSV, &size);
    CHECK_TEXT(two, "p1 time [s],p1 clearance [m],\"a \"\"b\"\", c time [s]\",\"a \"\"b\"\", c clearance [m]\"\r\n"
                    "0,0.1,-1,1234567.25\r\n1,,,\r\n2.5,1e-12,,\r\n");
    plot.series_count = 1;
    plot.y.unit = NULL;
    char *one = written(&plot, CSV, &size);
    CHECK_TEXT(one, "time [s],clearance [1]\r\n0,0.1\r\n1,\r\n2.5,1e-12\r\n");
    memory_free(two);
    memory_free(one);
}

/* Counts path operations in an SVG: moves, lines and curves. */
static size_t path_operations(const char *svg) {
    size_t count = 0;
    for (const char *path = svg; (path = strstr(path, " d=\"")) != NULL;)
        for (path += 4; *path && *path != '"'; path++)
            count += *path == 'M' || *path == 'L' || *path == 'C';
    return count;
}

TEST(a_hundred_thousand_points_are_drawn_with_few_operations) {
    static double x[MANY], y[MANY];
    fill_wave(x, y, MANY);
    for (size_t i = 0; i < MANY; i++)
        y[i] += i % 3;
    static double orbit[2][MANY]; /* of period 50 */
    for (size_t i = 0; i < MANY; i++) {
        orbit[0][i] = cos((double)(i % 50));
        orbit[1][i] = sin((double)(i % 50));
    }
    PlotSeries line = line_of("p1", x, y, MANY);
    PlotSeries points = {
        .x = orbit[0], .y = orbit[1], .count = MANY, .role = ROLE_LOCUS, .symbol = SYMBOL_BOX, .size = 2};
    Plot lines = plot_of(&line, 1), map = plot_of(&points, 1), empty = plot_of(NULL, 0);
    size_t size;
    char *svg[] = {written(&lines, CAIRO_FILE_SVG, &size), written(&map, CAIRO_FILE_SVG, &size),
                   written(&empty, CAIRO_FILE_SVG, &size)};
    size_t words = path_operations(svg[2]) + 500; /* glyphs of the axes */
    size_t columns = 2 * 800;                     /* of half a pixel */
    CHECK(path_operations(svg[0]) < words + 4 * columns + columns / 100);
    CHECK(path_operations(svg[0]) > columns);
    CHECK(path_operations(svg[1]) < words + 50 * 6);
    for (int i = 0; i < 3; i++)
        memory_free(svg[i]);
}

/* Maps and marks --------------------------------------------------------------------------------------------------- */

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
    cairo_surface_t *surface = painted_whole(&plot, 640, 400, 1);
    check_layout(&layout);
    CHECK(has_words(&layout, "period 1") && has_words(&layout, "not periodic"));
    for (int i = 0; i < 6; i++) {
        Vec2 corner = vec2(20 + 100 * (i % 3 + 0.1), 0.1 + 0.1 * (i / 3 + 0.1)); /* away from glyphs */
        Role role = isnan(values[i]) ? ROLE_PAPER : classes[(int)values[i]].role;
        CHECK(colour_at(surface, &layout, corner) == role_code(role));
    }
    cairo_surface_destroy(surface);
    plot_layout_clear(&layout);
    size_t size;
    char *table = written(&plot, CSV, &size);
    CHECK_TEXT(table, "frequency [Hz],clearance [mm],period\r\n70,0.15,period 1\r\n170,0.15,not periodic\r\n"
                      "270,0.15,\r\n70,0.25,not periodic\r\n170,0.25,period 1\r\n270,0.25,not periodic\r\n");
    memory_free(table);
}

TEST(a_quantity_is_told_by_brightness_in_both_themes) {
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

TEST(a_second_axis_and_a_key_leave_words_their_room) {
    static const double values[] = {0, 100, 3000, 70};
    PlotRaster raster = {{{20, 0.1}, {320, 0.3}}, 2, 2, values, NULL, 0, {.title = "largest peak", .unit = "N"}};
    Plot plot = {.title = "Peak force", .note = "set B", .x = {.title = "frequency"}, .y = {.title = "clearance"}};
    plot.raster = &raster;
    plot.right = (PlotAxis){.title = "g/a"};
    plot.right_factor = 12;
    for (size_t p = 1; p < sizeof PAGES / sizeof *PAGES; p++) {
        PlotLayout layout;
        plot_layout_make(&layout, &plot, PAGES[p], PLOT_NAMES_BESIDE);
        check_layout(&layout);
        CHECK(layout.right.count >= 2 && layout.shades.count >= 2);
        CHECK_NEAR(layout.right.high, 12 * 0.3, 1e-9);
        plot_layout_clear(&layout);
    }
}

TEST(bands_and_areas_fill_what_lies_between_and_nothing_else) {
    double x[] = {0, 1, 2, 3, 4}, low[] = {1, 1, NAN, 1, 1}, high[] = {3, 3, NAN, 3, 3};
    PlotArea area = {"5 to 95 %", x, low, high, 5, ROLE_SHADE};
    PlotGuide guide = {.upright = true, .band = true, .at = 3.5, .to = HUGE_VAL, .role = ROLE_FURNITURE};
    Plot plot = plot_of(NULL, 0);
    plot.areas = &area;
    plot.guides = &guide;
    plot.area_count = plot.guide_count = 1;
    plot.y.high = 4;
    PlotLayout layout;
    plot_layout_make(&layout, &plot, vec2(640, 400), PLOT_NAMES_BESIDE);
    cairo_surface_t *surface = painted_whole(&plot, 640, 400, 1);
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
    PlotSeries series[] = {line_of("stems", x, y, 3), line_of("measured", x, y, 3)};
    series[0].stems = true;
    series[1].width = 0;
    series[1].symbol = SYMBOL_TRIANGLE;
    series[1].size = 14;
    series[1].open = true;
    Plot plot = plot_of(series, 2);
    plot.x.high = plot.y.high = 4;
    PlotCanvas *canvas = plot_canvas_create(&plot, 400, 400, 1, THEME_PAPER);
    plot_canvas_advance(canvas, 1, 3);
    Vec2 middle = plot_canvas_place(canvas, vec2(2, 2));
    CHECK(ink_at(canvas, middle) < 64 && ink_at(canvas, vec2(middle.x, middle.y - 6)) > 128);
    plot_canvas_advance(canvas, 0, 3);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(3, 0.7))) > 128);
    CHECK(ink_at(canvas, plot_canvas_place(canvas, vec2(2.47, 2.47))) < 64);
    plot_canvas_destroy(canvas);
}
