#include "draw/plot_canvas.h"

#include <assert.h>
#include <cairo.h>
#include <string.h>

#include "draw/plot_ground.h"
#include "draw/plot_pen.h"

struct PlotCanvas {
    const Plot *plot;
    PlotLayout layout;
    PlotPen *pens; /* (series_count) */
    double unit;
    Theme theme;
    int width, height;
    cairo_surface_t *surface;
    cairo_t *cairo;
    unsigned char *ground; /* (height x stride) the pixels before anything is drawn */
};

static size_t pixel_bytes(const PlotCanvas *canvas) {
    return (size_t)canvas->height * (size_t)plot_canvas_stride(canvas);
}

static void reset_pens(PlotCanvas *canvas) {
    for (size_t s = 0; s < canvas->plot->series_count; s++)
        canvas->pens[s] = plot_pen_make(canvas->cairo);
}

PlotCanvas *plot_canvas_create(const Plot *plot, int width, int height, double unit, Theme theme) {
    assert(width > 0 && height > 0 && unit > 0);
    PlotCanvas *canvas = memory_allocate(1, sizeof *canvas);
    *canvas = (PlotCanvas){.plot = plot, .unit = unit, .theme = theme, .width = width, .height = height};
    plot_layout_make(&canvas->layout, plot, vec2(width / unit, height / unit), PLOT_NAMES_ABOVE);
    canvas->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    canvas->cairo = cairo_create(canvas->surface);
    cairo_scale(canvas->cairo, unit, unit);
    plot_ground_paint(canvas->cairo, &canvas->layout, plot, theme);
    cairo_surface_flush(canvas->surface);
    canvas->ground = memory_allocate(pixel_bytes(canvas), 1);
    memcpy(canvas->ground, plot_canvas_pixels(canvas), pixel_bytes(canvas));
    canvas->pens = memory_allocate(plot->series_count, sizeof *canvas->pens);
    reset_pens(canvas);
    return canvas;
}

void plot_canvas_destroy(PlotCanvas *canvas) {
    cairo_destroy(canvas->cairo);
    cairo_surface_destroy(canvas->surface);
    plot_layout_clear(&canvas->layout);
    memory_free(canvas->pens);
    memory_free(canvas->ground);
    memory_free(canvas);
}

/* The whole pixels of the canvas that a box in design points touches. */
static PlotPixels to_pixels(const PlotCanvas *canvas, Box box) {
    double left = floor(fmax(0, box.low.x * canvas->unit)), top = floor(fmax(0, box.low.y * canvas->unit));
    double right = ceil(fmin(canvas->width, box.high.x * canvas->unit));
    double bottom = ceil(fmin(canvas->height, box.high.y * canvas->unit));
    if (!(left < right && top < bottom))
        return (PlotPixels){0};
    return (PlotPixels){(int)left, (int)top, (int)(right - left), (int)(bottom - top)};
}

PlotPixels plot_canvas_advance(PlotCanvas *canvas, size_t series, size_t count) {
    assert(series < canvas->plot->series_count);
    const PlotSeries *drawn = &canvas->plot->series[series];
    if (count > drawn->count)
        count = drawn->count;
    if (count <= canvas->pens[series].next)
        return (PlotPixels){0};
    Box box = plot_pen_draw(&canvas->pens[series], canvas->cairo, &canvas->layout, drawn, count, canvas->theme);
    cairo_surface_flush(canvas->surface);
    return to_pixels(canvas, box);
}

void plot_canvas_restart(PlotCanvas *canvas) {
    cairo_surface_flush(canvas->surface);
    memcpy(cairo_image_surface_get_data(canvas->surface), canvas->ground, pixel_bytes(canvas));
    cairo_surface_mark_dirty(canvas->surface);
    reset_pens(canvas);
}

PlotPixels plot_canvas_all(const PlotCanvas *canvas) {
    return (PlotPixels){0, 0, canvas->width, canvas->height};
}

const unsigned char *plot_canvas_pixels(const PlotCanvas *canvas) {
    return cairo_image_surface_get_data(canvas->surface);
}

int plot_canvas_stride(const PlotCanvas *canvas) {
    return cairo_image_surface_get_stride(canvas->surface);
}

Vec2 plot_canvas_place(const PlotCanvas *canvas, Vec2 value) {
    return vec2_scale(plot_layout_point(&canvas->layout, value), canvas->unit);
}
