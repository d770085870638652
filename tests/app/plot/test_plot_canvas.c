#include "check.h"

#include <cairo.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "plot/plot_canvas.h"
#include "sample_plot.h"

enum { MANY = 100000 };

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

/* Compares a canvas advanced by at most `most` points per step with the same plot painted at once. */
static void check_bit_by_bit(Plot *plot, int most) {
    enum { WIDTH = 576, HEIGHT = 225 };
    PlotGuide guide = {.at = 0.4, .name = "danger below", .role = ROLE_ERROR, .style = LINE_DASHED};
    plot->guides = &guide;
    plot->guide_count = 1;
    cairo_surface_t *whole = sample_painted(plot, WIDTH, HEIGHT, 1.5);
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
            sample_fill_wave(x, y, COUNT);
            y[1200] = y[1500] = NAN;
            PlotSeries series = sample_line("p1", x, y, COUNT);
            series.style = style;
            Plot plot = sample_plot(&series, 1);
            check_bit_by_bit(&plot, most);
        }
}

TEST(points_drawn_bit_by_bit_are_the_points_drawn_at_once) {
    enum { COUNT = 500 };
    static double x[COUNT], y[COUNT];
    sample_fill_wave(x, y, COUNT);
    for (Symbol symbol = SYMBOL_DISC; symbol < SYMBOLS; symbol++) {
        PlotSeries series = {.x = x, .y = y, .count = COUNT, .role = ROLE_LOCUS, .symbol = symbol, .size = 4};
        Plot plot = sample_plot(&series, 1);
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
    sample_fill_wave(x, y, COUNT);
    PlotSeries series[] = {sample_line("p1", x, y, COUNT), sample_line("p2", y, x, COUNT)};
    series[1].symbol = SYMBOL_DISC;
    series[1].size = 7;
    Plot plot = sample_plot(series, 2);
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

TEST(one_point_of_many_that_stands_out_is_seen) {
    static double x[MANY], y[MANY];
    for (size_t i = 0; i < MANY; i++) {
        x[i] = (double)i;
        y[i] = 0.01 * (double)(i % 7);
    }
    static const size_t spikes[] = {3, 31415, 31416 + 250, 77777, MANY - 2};
    for (size_t s = 0; s < 5; s++)
        y[spikes[s]] = s % 2 ? -1 : 1;
    PlotSeries series = sample_line("p1", x, y, MANY);
    Plot plot = sample_plot(&series, 1);
    PlotCanvas *canvas = plot_canvas_create(&plot, 384, 150, 1, THEME_PAPER);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(31415, -0.5))) < 64);
    plot_canvas_advance(canvas, 0, MANY);
    for (size_t s = 0; s < 5; s++)
        CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(x[spikes[s]], 0.95 * y[spikes[s]]))) > 128);
    plot_canvas_destroy(canvas);
}

TEST(a_series_may_grow_and_move_while_it_is_drawn) {
    double first[] = {0, 1, 2}, longer[] = {0, 1, 2, 3, 4, 5};
    PlotSeries series = sample_line("p1", first, first, 3);
    Plot plot = sample_plot(&series, 1);
    plot.x.high = plot.y.high = 5;
    PlotCanvas *canvas = plot_canvas_create(&plot, 300, 300, 1, THEME_PAPER);
    plot_canvas_advance(canvas, 0, 3);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(3.6, 3.6))) < 64);
    series.x = series.y = longer;
    series.count = 6;
    plot_canvas_advance(canvas, 0, 6);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(1.6, 1.6))) > 128);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(3.6, 3.6))) > 128);
    plot_canvas_destroy(canvas);
}

TEST(a_value_that_is_not_a_number_breaks_the_line_and_a_single_point_is_a_dot) {
    double x[] = {0, 1, 2, 3, 4, 5, 6}, y[] = {1, 1, NAN, 1, INFINITY, 1, 1};
    PlotSeries series = sample_line("p1", x, y, 7);
    Plot plot = sample_plot(&series, 1);
    plot.y.high = 2;
    PlotCanvas *canvas = plot_canvas_create(&plot, 384, 150, 1, THEME_PAPER);
    plot_canvas_advance(canvas, 0, 7);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(0.5, 1))) > 128);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(2.5, 1))) < 64);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(3, 1))) > 128);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(4.5, 1))) < 64);
    CHECK(sample_ink(canvas, plot_canvas_place(canvas, vec2(5.5, 1))) > 128);
    plot_canvas_destroy(canvas);
}
