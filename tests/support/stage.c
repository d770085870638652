#include "stage.h"

#include <cairo.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "check.h"
#include "paint/paint_cairo.h"

Picture picture_make(int width, int height) {
    return (Picture){memory_zeroed((size_t)width * (size_t)height, 4), width, height};
}

const unsigned char *picture_at(const Picture *picture, int x, int y) {
    return picture->pixels + 4 * ((size_t)y * (size_t)picture->width + (size_t)x);
}

static int difference(const unsigned char *a, const unsigned char *b) {
    int most = 0;
    for (int i = 0; i < 3; i++)
        most = abs(a[i] - b[i]) > most ? abs(a[i] - b[i]) : most;
    return most;
}

Box picture_changed(const Picture *picture, const Picture *ground, int least) {
    Box box = box_empty();
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++)
            if (difference(picture_at(picture, x, y), picture_at(ground, x, y)) > least) {
                box = box_include(box, vec2(x, y));
                box = box_include(box, vec2(x + 1, y + 1));
            }
    return box;
}

void picture_mean(const Picture *picture, Vec2 at, int reach, double mean[3]) {
    int count = 0;
    memset(mean, 0, 3 * sizeof *mean);
    for (int y = (int)at.y - reach; y <= (int)at.y + reach; y++)
        for (int x = (int)at.x - reach; x <= (int)at.x + reach; x++, count++)
            for (int i = 0; i < 3; i++)
                mean[i] += picture_at(picture, x, y)[i];
    for (int i = 0; i < 3; i++)
        mean[i] /= count;
}

bool picture_equals(const Picture *a, const Picture *b) {
    return memcmp(a->pixels, b->pixels, 4 * (size_t)a->width * (size_t)a->height) == 0;
}

Stage stage_begin(OffscreenKind kind, int width, int height, Theme theme) {
    char message[OFFSCREEN_MESSAGE];
    Stage stage = {.offscreen = offscreen_create(kind, message), .picture = picture_make(width, height)};
    if (!stage.offscreen)
        check_skip(message);
    stage.page = vec2_scale(vec2(width, height), 1 / layout_unit(width, height));
    stage.paint = paint_gl_create(offscreen_gl(stage.offscreen), width, height, layout_unit(width, height), theme);
    CHECK(stage.paint);
    return stage;
}

void stage_end(Stage *stage) {
    paint_gl_destroy(stage->paint);
    offscreen_destroy(stage->offscreen);
    memory_free(stage->picture.pixels);
}

void stage_show(Stage *stage, const Scene *still, const Scene *moving) {
    Layout under, over = {0};
    layout_make(&under, still, stage->page);
    layout_make_over(&over, &under, moving);
    paint_gl_still(stage->paint, (Layer){still, &under});
    paint_gl_frame(stage->paint, (Layer){moving, &over});
    paint_gl_read(stage->paint, stage->picture.pixels);
    layout_clear(&under);
    layout_clear(&over);
}

void stage_show_by_cairo(Picture *picture, const Scene *still, const Scene *moving, Theme theme) {
    double unit = layout_unit(picture->width, picture->height);
    Layout under, over = {0};
    layout_make(&under, still, vec2(picture->width / unit, picture->height / unit));
    layout_make_over(&over, &under, moving);
    cairo_surface_t *surface = cairo_image_surface_create_for_data(picture->pixels, CAIRO_FORMAT_RGB24, picture->width,
                                                                   picture->height, 4 * picture->width);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, unit, unit);
    paint_cairo_layers(cairo, (Layer[]){{still, &under}, {moving, &over}}, 2, theme);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
    layout_clear(&under);
    layout_clear(&over);
}
