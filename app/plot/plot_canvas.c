#include "plot/plot_canvas.h"

#include <assert.h>
#include <cairo.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "draw/cairo_memory.h"
#include "plot/plot_frame.h"
#include "plot/plot_ground.h"
#include "plot/plot_pen.h"

/* A new piece of a line is drawn on an empty sheet. Its ink is joined to the ink of its series by the larger of the
 * two, since ink over ink would blacken the blurred edges where pieces meet; then the touched pixels are composed
 * again, from the ground upwards. */
struct PlotCanvas {
    const Plot *plot;
    PlotLayout layout;
    PlotPen *pens; /* (pen_count) one per series */
    size_t pen_count;
    double unit;
    Theme theme;
    int width, height;
    cairo_surface_t *sheet; /* 8 bits per pixel, empty between two drawings */
    cairo_t *cairo;         /* on the sheet */
    unsigned char *ink;     /* (pen_count x height x width) */
    uint32_t *ground;       /* (height x width) */
    uint32_t *text;         /* (height x width) on top; premultiplied by the opacity, which is the highest byte */
    uint32_t *pixels;       /* (height x width) */
};

static size_t pixel_count(const PlotCanvas *canvas) {
    return (size_t)canvas->width * (size_t)canvas->height;
}

/* Returns a context that paints on pixels of the canvas. */
static cairo_t *begin_painting(const PlotCanvas *canvas, uint32_t *pixels, cairo_format_t format) {
    cairo_surface_t *surface = cairo_image_surface_create_for_data((unsigned char *)pixels, format, canvas->width,
                                                                   canvas->height, plot_canvas_stride(canvas));
    cairo_t *cairo = cairo_create(surface);
    cairo_surface_destroy(surface);
    cairo_scale(cairo, canvas->unit, canvas->unit);
    return cairo;
}

static void paint_ground(PlotCanvas *canvas) {
    cairo_t *cairo = begin_painting(canvas, canvas->ground, CAIRO_FORMAT_RGB24);
    plot_ground_paint(cairo, &canvas->layout, canvas->plot, canvas->theme);
    cairo_memory_end(cairo);
    cairo = begin_painting(canvas, canvas->text, CAIRO_FORMAT_ARGB32);
    plot_ground_paint_text(cairo, &canvas->layout, canvas->theme);
    cairo_memory_end(cairo);
}

PlotCanvas *plot_canvas_create(const Plot *plot, int width, int height, double unit, Theme theme) {
    assert(width > 0 && height > 0 && unit > 0);
    PlotCanvas *canvas = memory_zeroed(1, sizeof *canvas);
    *canvas = (PlotCanvas){.plot = plot, .unit = unit, .theme = theme, .width = width, .height = height};
    canvas->pen_count = plot->series_count;
    canvas->pens = memory_zeroed(canvas->pen_count, sizeof *canvas->pens);
    canvas->ink = memory_zeroed(canvas->pen_count * pixel_count(canvas), 1);
    canvas->ground = memory_zeroed(pixel_count(canvas), sizeof *canvas->ground);
    canvas->text = memory_zeroed(pixel_count(canvas), sizeof *canvas->text);
    canvas->pixels = memory_zeroed(pixel_count(canvas), sizeof *canvas->pixels);
    canvas->sheet = cairo_image_surface_create(CAIRO_FORMAT_A8, width, height);
    canvas->cairo = cairo_create(canvas->sheet);
    cairo_scale(canvas->cairo, unit, unit);
    plot_layout_make(&canvas->layout, plot, vec2(width / unit, height / unit), PLOT_NAMES_ABOVE);
    paint_ground(canvas);
    plot_canvas_restart(canvas);
    return canvas;
}

const PlotLayout *plot_canvas_layout(const PlotCanvas *canvas) {
    return &canvas->layout;
}

void plot_canvas_destroy(PlotCanvas *canvas) {
    for (size_t s = 0; s < canvas->pen_count; s++)
        plot_pen_clear(&canvas->pens[s]);
    plot_layout_clear(&canvas->layout);
    cairo_destroy(canvas->cairo);
    cairo_surface_destroy(canvas->sheet);
    memory_free(canvas->pens);
    memory_free(canvas->ink);
    memory_free(canvas->ground);
    memory_free(canvas->text);
    memory_free(canvas->pixels);
    memory_free(canvas);
}

/* Returns the whole pixels of the canvas that a box in design points touches. */
static PlotPixels to_pixels(const PlotCanvas *canvas, Box box) {
    double left = floor(fmax(0, box.low.x * canvas->unit)), top = floor(fmax(0, box.low.y * canvas->unit));
    double right = ceil(fmin(canvas->width, box.high.x * canvas->unit));
    double bottom = ceil(fmin(canvas->height, box.high.y * canvas->unit));
    if (!(left < right && top < bottom))
        return (PlotPixels){0};
    return (PlotPixels){(int)left, (int)top, (int)(right - left), (int)(bottom - top)};
}

/* Clears the ink from the sheet. */
static void join_ink(PlotCanvas *canvas, size_t series, PlotPixels part) {
    int stride = cairo_image_surface_get_stride(canvas->sheet);
    cairo_surface_flush(canvas->sheet);
    for (int y = part.y; y < part.y + part.height; y++) {
        unsigned char *fresh = cairo_image_surface_get_data(canvas->sheet) + (size_t)y * (size_t)stride;
        unsigned char *ink = canvas->ink + series * pixel_count(canvas) + (size_t)y * (size_t)canvas->width;
        for (int x = part.x; x < part.x + part.width; x++) {
            ink[x] = fresh[x] > ink[x] ? fresh[x] : ink[x];
            fresh[x] = 0;
        }
    }
    cairo_surface_mark_dirty(canvas->sheet);
}

/* Returns one colour with `ink` of 255 of another over it, channel by channel. */
static uint32_t mixed(uint32_t under, uint32_t over, uint32_t ink) {
    uint32_t result = 0;
    for (int shift = 0; shift < 24; shift += 8)
        result |= ((under >> shift & 255) * (255 - ink) + (over >> shift & 255) * ink + 127) / 255 << shift;
    return result;
}

static uint32_t pixel_of(Colour colour) {
    return (uint32_t)lround(255 * colour.red) << 16 | (uint32_t)lround(255 * colour.green) << 8 |
           (uint32_t)lround(255 * colour.blue);
}

static void lay_over(PlotCanvas *canvas, size_t series, PlotPixels part) {
    uint32_t over = pixel_of(palette_colour(canvas->theme, canvas->plot->series[series].role));
    for (int y = part.y; y < part.y + part.height; y++) {
        size_t row = (size_t)y * (size_t)canvas->width;
        const unsigned char *ink = canvas->ink + series * pixel_count(canvas) + row;
        uint32_t *pixels = canvas->pixels + row;
        for (int x = part.x; x < part.x + part.width; x++)
            if (ink[x])
                pixels[x] = mixed(pixels[x], over, ink[x]);
    }
}

static void lay_text_over(PlotCanvas *canvas, PlotPixels part) {
    for (int y = part.y; y < part.y + part.height; y++)
        for (int x = part.x; x < part.x + part.width; x++) {
            size_t i = (size_t)y * (size_t)canvas->width + (size_t)x;
            uint32_t pixel = canvas->text[i];
            if (pixel >> 24)
                canvas->pixels[i] = (pixel & 0xFFFFFF) + mixed(canvas->pixels[i], 0, pixel >> 24);
        }
}

static void compose(PlotCanvas *canvas, PlotPixels part) {
    for (int y = part.y; y < part.y + part.height; y++) {
        size_t first = (size_t)y * (size_t)canvas->width + (size_t)part.x;
        memcpy(canvas->pixels + first, canvas->ground + first, (size_t)part.width * sizeof *canvas->pixels);
    }
    for (size_t s = 0; s < canvas->pen_count; s++)
        lay_over(canvas, s, part);
    lay_text_over(canvas, part);
}

PlotPixels plot_canvas_advance(PlotCanvas *canvas, size_t series, size_t count) {
    assert(series < canvas->pen_count);
    const PlotSeries *drawn = &canvas->plot->series[series];
    if (count > drawn->count)
        count = drawn->count;
    if (count <= canvas->pens[series].next)
        return (PlotPixels){0};
    Box box = plot_pen_draw(&canvas->pens[series], canvas->cairo, &canvas->layout, drawn, count, canvas->theme);
    cairo_memory_check(canvas->cairo);
    PlotPixels part = to_pixels(canvas, box);
    join_ink(canvas, series, part);
    compose(canvas, part);
    return part;
}

void plot_canvas_restart(PlotCanvas *canvas) {
    for (size_t s = 0; s < canvas->pen_count; s++) {
        plot_pen_clear(&canvas->pens[s]);
        canvas->pens[s] = plot_pen_make(canvas->cairo);
    }
    memset(canvas->ink, 0, canvas->pen_count * pixel_count(canvas));
    compose(canvas, (PlotPixels){0, 0, canvas->width, canvas->height});
}

PlotPixels plot_canvas_all(const PlotCanvas *canvas) {
    return (PlotPixels){0, 0, canvas->width, canvas->height};
}

const unsigned char *plot_canvas_pixels(const PlotCanvas *canvas) {
    return (const unsigned char *)canvas->pixels;
}

int plot_canvas_stride(const PlotCanvas *canvas) {
    return canvas->width * (int)sizeof *canvas->pixels;
}

Vec2 plot_canvas_place(const PlotCanvas *canvas, Vec2 value) {
    return vec2_scale(plot_frame_point(&canvas->layout, value), canvas->unit);
}

Box plot_canvas_frame(const PlotCanvas *canvas) {
    Box frame = canvas->layout.sheet.frame;
    return (Box){vec2_scale(frame.low, canvas->unit), vec2_scale(frame.high, canvas->unit)};
}

/* Returns the value at this share of an axis, 0 to 1. */
static double value_along(const PlotTicks *ticks, double part) {
    if (ticks->logarithmic)
        return ticks->low * pow(ticks->high / ticks->low, part);
    return ticks->low + part * (ticks->high - ticks->low);
}

Vec2 plot_canvas_value(const PlotCanvas *canvas, Vec2 place) {
    Box frame = plot_canvas_frame(canvas);
    return vec2(value_along(&canvas->layout.x, (place.x - frame.low.x) / box_width(frame)),
                value_along(&canvas->layout.y, (frame.high.y - place.y) / box_height(frame)));
}
