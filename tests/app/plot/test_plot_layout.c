#include <string.h>

#include "check.h"

#include "plot/plot_canvas.h"
#include "plot/plot_frame.h"
#include "plot/plot_layout.h"
#include "sample_plot.h"

static const Vec2 pages[] = {{384, 150}, {384, 300}, {640, 400}, {1280, 720}};

TEST(no_words_overlap_or_leave_the_page_whatever_the_numbers) {
    static const struct {
        double low, high;
    } values[] = {{0, 1},     {-1234, 98765}, {1e-9, 2e-9},  {-1e12, 1e12},   {0.1, 0.1},    {-5, -5},
                  {0, 12345}, {NAN, NAN},     {INFINITY, 1}, {99999, 100001}, {1e9, 1e9 + 1}};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
            double numbers[] = {values[i].low, values[i].high}, turned[] = {values[i].high, values[i].low};
            double plain[] = {0, 1};
            PlotSeries series[] = {sample_line("before", numbers, numbers, 2), sample_line("p1", numbers, turned, 2)};
            if (p % 2)
                series[0].y = series[1].y = plain;
            PlotGuide guide = {.at = values[i].high, .name = "danger below", .role = ROLE_ERROR};
            Plot plot = sample_plot(series, 2);
            plot.note = "6 of 40 people";
            plot.guides = &guide;
            plot.guide_count = 1;
            for (PlotNames names = PLOT_NAMES_BESIDE; names <= PLOT_NAMES_ABOVE; names++) {
                PlotLayout layout;
                plot_layout_make(&layout, &plot, pages[p], names);
                sample_check_layout(&layout);
                plot_layout_clear(&layout);
            }
        }
}

/* Fills in a wave of 100 points and another one, `apart` above it. */
static void fill_two_waves(double *x, double *low, double *high, double apart) {
    sample_fill_wave(x, low, 100);
    for (int i = 0; i < 100; i++)
        high[i] = low[i] + apart;
}

TEST(names_stand_at_lines_that_are_apart_and_above_lines_that_are_not) {
    double x[100], low[100], high[100];
    fill_two_waves(x, low, high, 2);
    PlotSeries apart[] = {sample_line("low", x, low, 100), sample_line("high", x, high, 100)};
    PlotSeries same[] = {sample_line("low", x, low, 100), sample_line("high", x, low, 100)};
    for (size_t p = 1; p < sizeof pages / sizeof *pages; p++) {
        Plot first = sample_plot(apart, 2), second = sample_plot(same, 2);
        PlotLayout beside, above;
        plot_layout_make(&beside, &first, pages[p], PLOT_NAMES_BESIDE);
        plot_layout_make(&above, &second, pages[p], PLOT_NAMES_BESIDE);
        CHECK(beside.sheet.sample_count == 0 && sample_has_text(&beside, "low") && sample_has_text(&beside, "high"));
        CHECK(above.sheet.sample_count == 2 && sample_has_text(&above, "low") && sample_has_text(&above, "high"));
        plot_layout_clear(&beside);
        plot_layout_clear(&above);
    }
}

TEST(many_long_names_leave_the_plot_its_height) {
    double x[] = {0, 1}, y[] = {0, 1};
    PlotSeries series[6];
    for (int i = 0; i < 6; i++)
        series[i] = sample_line("a person with quite a long name", x, y, 2);
    Plot plot = sample_plot(series, 6);
    for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
        PlotLayout layout;
        plot_layout_make(&layout, &plot, pages[p], PLOT_NAMES_ABOVE);
        sample_check_layout(&layout);
        CHECK(sample_has_text(&layout, series[0].name) == (pages[p].y > 300));
        plot_layout_clear(&layout);
    }
}

/* True if a text stands at a place across. */
static bool has_label_at(const PlotLayout *layout, const char *label, double x) {
    for (size_t i = 0; i < layout->sheet.caption_count; i++) {
        const Caption *caption = &layout->sheet.captions[i];
        if (strcmp(caption->text, label) == 0 && fabs(caption->centre.x - x) < 1)
            return true;
    }
    return false;
}

TEST(every_tick_has_its_number_also_in_a_low_plot) {
    static const Vec2 low[] = {{480, 138}, {310, 138}, {230, 112}, {640, 138}, {340, 199}, {340, 220}};
    static const double ends[] = {1, 10, 50, 320, 1000, 26.1, 0.004};
    for (size_t p = 0; p < sizeof low / sizeof *low; p++)
        for (size_t e = 0; e < sizeof ends / sizeof *ends; e++) {
            double x[] = {0, ends[e]}, y[] = {-3, 7};
            PlotSeries series = sample_line("p1", x, y, 2);
            Plot plot = sample_plot(&series, 1);
            plot.x.title = "lateral displacement";
            plot.x.unit = "mm";
            PlotLayout layout;
            plot_layout_make(&layout, &plot, low[p], PLOT_NAMES_ABOVE);
            sample_check_layout(&layout);
            for (int i = 0; i < layout.x.count; i++) {
                char label[PLOT_TICKS_LABEL];
                plot_ticks_label(&layout.x, i, label);
                CHECK(has_label_at(&layout, label, plot_frame_point(&layout, vec2(plot_ticks_at(&layout.x, i), 0)).x));
            }
            plot_layout_clear(&layout);
        }
}

TEST(an_empty_plot_has_axes) {
    PlotSeries none = sample_line("none", NULL, NULL, 0);
    Plot plots[] = {sample_plot(NULL, 0), sample_plot(&none, 1)};
    for (int i = 0; i < 2; i++) {
        PlotLayout layout;
        plot_layout_make(&layout, &plots[i], pages[0], PLOT_NAMES_BESIDE);
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
    PlotSeries series = sample_line("p1", x, y, 2);
    Plot plot = sample_plot(&series, 1);
    plot.x.low = 1.3;
    plot.x.high = 2.7;
    PlotLayout layout;
    plot_layout_make(&layout, &plot, pages[1], PLOT_NAMES_BESIDE);
    CHECK_NEAR(plot_frame_point(&layout, vec2(1.3, 0)).x, layout.sheet.frame.low.x, 1e-9);
    CHECK_NEAR(plot_frame_point(&layout, vec2(2.7, 0)).x, layout.sheet.frame.high.x, 1e-9);
    plot_layout_clear(&layout);
}

TEST(a_second_axis_and_a_key_leave_words_their_room) {
    static const double values[] = {0, 100, 3000, 70};
    PlotRaster raster = {{{20, 0.1}, {320, 0.3}}, 2, 2, values, NULL, 0, {.title = "largest peak", .unit = "N"}};
    Plot plot = {.title = "Peak force", .note = "set B", .x = {.title = "frequency"}, .y = {.title = "clearance"}};
    plot.raster = &raster;
    plot.right = (PlotAxis){.title = "g/a"};
    plot.right_factor = 12;
    for (size_t p = 1; p < sizeof pages / sizeof *pages; p++) {
        PlotLayout layout;
        plot_layout_make(&layout, &plot, pages[p], PLOT_NAMES_BESIDE);
        sample_check_layout(&layout);
        CHECK(layout.right.count >= 2 && layout.shades.count >= 2);
        CHECK_NEAR(layout.right.high, 12 * 0.3, 1e-9);
        plot_layout_clear(&layout);
    }
}

TEST(a_long_title_ends_before_what_it_is_of) {
    double x[] = {0, 1}, y[] = {0, 1};
    PlotSeries series = sample_line("path", x, y, 2);
    const char *const titles[][2] = {{"Phase plane of the ball in its socket", "Phase plane"},
                                     {"Orbit diagram: peak force of the joint", "Orbit diagram"},
                                     {"Orbits over the speed (orbit diagram)", "Orbits over the speed"}};
    for (size_t t = 0; t < sizeof titles / sizeof *titles; t++) {
        Plot plot = sample_plot(&series, 1);
        plot.title = titles[t][0];
        PlotLayout wide, narrow;
        plot_layout_make(&wide, &plot, vec2(640, 300), PLOT_NAMES_BESIDE);
        plot_layout_make(&narrow, &plot, vec2(240, 150), PLOT_NAMES_BESIDE);
        CHECK(sample_has_text(&wide, titles[t][0]) && sample_has_text(&narrow, titles[t][1]));
        plot_layout_clear(&wide);
        plot_layout_clear(&narrow);
    }
}

TEST(a_listed_guide_is_named_above_the_plot_with_a_sample_of_its_line) {
    double x[100], low[100], high[100];
    fill_two_waves(x, low, high, 0.1);
    PlotSeries series[] = {sample_line("e1", x, low, 100), sample_line("e2", x, high, 100)};
    PlotGuide guide = {.at = 0.5, .name = "capacity", .listed = true, .role = ROLE_DIM_TEXT, .style = LINE_DASHED};
    Plot plot = sample_plot(series, 2);
    plot.guides = &guide;
    plot.guide_count = 1;
    for (size_t p = 1; p < sizeof pages / sizeof *pages; p++) {
        PlotLayout layout;
        plot_layout_make(&layout, &plot, pages[p], PLOT_NAMES_ABOVE);
        sample_check_layout(&layout);
        CHECK(layout.sheet.sample_count == 3 && sample_has_text(&layout, "capacity"));
        for (size_t i = 0; i < layout.sheet.caption_count; i++)
            if (strcmp(layout.sheet.captions[i].text, "capacity") == 0)
                CHECK(layout.sheet.captions[i].centre.y < layout.sheet.frame.low.y);
        plot_layout_clear(&layout);
    }
}
