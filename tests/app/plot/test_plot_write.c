#include "check.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "paint/cairo_file.h"
#include "plot/plot_write.h"
#include "sample_plot.h"

enum { MANY = 100000 };

TEST(the_same_plot_gives_the_same_bytes) {
    static const char *const beginnings[] = {
        [CAIRO_FILE_PNG] = "\x89PNG", [CAIRO_FILE_SVG] = "<?xml", [CAIRO_FILE_PDF] = "%PDF"};
    double x[200], y[200];
    sample_fill_wave(x, y, 200);
    PlotSeries series[] = {sample_line("p1", x, y, 200), sample_line("p2", y, x, 200)};
    Plot plot = sample_plot(series, 2);
    for (int i = CAIRO_FILE_PNG; i <= CAIRO_FILE_PDF; i++) {
        size_t first_size = 0, second_size = 1;
        char *first = sample_written(&plot, i, &first_size);
        sleep(i == CAIRO_FILE_PDF); /* a date would change the bytes */
        char *second = sample_written(&plot, i, &second_size);
        CHECK(first && second && first_size == second_size && memcmp(first, second, first_size) == 0);
        CHECK(first && memcmp(first, beginnings[i], strlen(beginnings[i])) == 0);
        memory_free(first);
        memory_free(second);
    }
}

TEST(a_plot_that_cannot_be_written_says_why) {
    Plot plot = sample_plot(NULL, 0);
    CHECK(plot_write_picture(CAIRO_FILE_PNG, &plot, "/tmp/clearance-never.png", &(PlotSheet){.height = 100}) == EINVAL);
    CHECK(plot_write_picture(CAIRO_FILE_PDF, &plot, "/tmp/clearance-never.pdf",
                             &(PlotSheet){100, CAIRO_FILE_LARGEST + 1, THEME_PAPER, NULL}) == EINVAL);
    CHECK(plot_write_picture(CAIRO_FILE_SVG, &plot, "/tmp/no-such-directory/a.svg",
                             &(PlotSheet){100, 100, THEME_PAPER, NULL}) == ENOENT);
    CHECK(plot_write_csv(&plot, "/tmp/no-such-directory/a.csv") == ENOENT);
    CHECK(access("/tmp/clearance-never.png", F_OK) != 0);
}

TEST(a_table_has_two_columns_a_series_and_names_them) {
    double rows[][3] = {{0, 7, 0.1}, {1, 7, NAN}, {2.5, 7, 1e-12}}, x[] = {-1}, y[] = {1234567.25};
    PlotSeries series[] = {sample_line("p1", &rows[0][0], &rows[0][2], 3), sample_line("a \"b\", c", x, y, 1)};
    series[0].stride = 3;
    series[1].heading = series[1].name;
    series[1].name = NULL;
    Plot plot = sample_plot(series, 2);
    size_t size;
    char *two = sample_written(&plot, SAMPLE_CSV, &size);
    CHECK_TEXT(two, "p1 time [s],p1 clearance [m],\"a \"\"b\"\", c time [s]\",\"a \"\"b\"\", c clearance [m]\"\r\n"
                    "0,0.1,-1,1234567.25\r\n1,,,\r\n2.5,1e-12,,\r\n");
    plot.series_count = 1;
    plot.y.unit = NULL;
    char *one = sample_written(&plot, SAMPLE_CSV, &size);
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
    sample_fill_wave(x, y, MANY);
    for (size_t i = 0; i < MANY; i++)
        y[i] += i % 3;
    static double orbit[2][MANY]; /* of period 50 */
    for (size_t i = 0; i < MANY; i++) {
        orbit[0][i] = cos((double)(i % 50));
        orbit[1][i] = sin((double)(i % 50));
    }
    PlotSeries line = sample_line("p1", x, y, MANY);
    PlotSeries points = {
        .x = orbit[0], .y = orbit[1], .count = MANY, .role = ROLE_LOCUS, .symbol = SYMBOL_BOX, .size = 2};
    Plot lines = sample_plot(&line, 1), map = sample_plot(&points, 1), empty = sample_plot(NULL, 0);
    size_t size;
    char *svg[] = {sample_written(&lines, CAIRO_FILE_SVG, &size), sample_written(&map, CAIRO_FILE_SVG, &size),
                   sample_written(&empty, CAIRO_FILE_SVG, &size)};
    size_t words = path_operations(svg[2]) + 500; /* glyphs of the axes */
    size_t columns = 2 * 800;                     /* of half a pixel */
    CHECK(path_operations(svg[0]) < words + 4 * columns + columns / 100);
    CHECK(path_operations(svg[0]) > columns);
    CHECK(path_operations(svg[1]) < words + 50 * 6);
    for (int i = 0; i < 3; i++)
        memory_free(svg[i]);
}
