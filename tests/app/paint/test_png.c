/* Tests that PNG files read back equal the drawn pictures, with any number of threads. */

#include "paint/png.h"

#include <cairo.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"

enum { WIDTH = 37, HEIGHT = 23, PICTURES = 25 };

static void fill(unsigned char *pixels, int picture) {
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++)
        pixels[i] = (unsigned char)(i * 7 + picture * 31);
}

/* True if the file equals the picture, pixel by pixel. */
static void check_file(const char *path, int picture) {
    unsigned char pixels[WIDTH * HEIGHT * 4];
    fill(pixels, picture);
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    CHECK(cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS);
    CHECK(cairo_image_surface_get_width(surface) == WIDTH && cairo_image_surface_get_height(surface) == HEIGHT);
    int stride = cairo_image_surface_get_stride(surface), different = 0;
    const unsigned char *read = cairo_image_surface_get_data(surface);
    for (int y = 0; read && y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            different += memcmp(read + y * stride + 4 * x, pixels + 4 * (y * WIDTH + x), 3) != 0;
    CHECK(read && different == 0);
    cairo_surface_destroy(surface);
}

TEST(pictures_are_written_in_any_number_of_threads) {
    char directory[CHECK_PATH], path[CHECK_PATH + 16];
    check_temporary(directory, "png-XXXXXX");
    CHECK(mkdtemp(directory));
    for (int threads = 1; threads <= 4; threads++) {
        PngWriter *writer = png_writer_create(WIDTH, HEIGHT, threads);
        for (int i = 0; i < PICTURES; i++) {
            fill(png_writer_room(writer), i + threads);
            snprintf(path, sizeof path, "%s/%d.png", directory, i);
            png_writer_put(writer, path);
        }
        CHECK(png_writer_finish(writer) == 0);
        for (int i = 0; i < PICTURES; i++) {
            snprintf(path, sizeof path, "%s/%d.png", directory, i);
            check_file(path, i + threads);
            CHECK(unlink(path) == 0);
        }
    }
    CHECK(rmdir(directory) == 0); /* no other files remain in the folder */
}

TEST(what_cannot_be_written_is_told_once_and_for_all) {
    PngWriter *writer = png_writer_create(WIDTH, HEIGHT, 2);
    for (int i = 0; i < PICTURES; i++) {
        fill(png_writer_room(writer), i);
        png_writer_put(writer, "/tmp/no-such-directory/a.png");
    }
    CHECK(png_writer_finish(writer) == ENOENT);
}
