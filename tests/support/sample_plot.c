#include "sample_plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"
#include "plot/plot_write.h"

void sample_fill_wave(double *x, double *y, size_t count) {
    for (size_t i = 0; i < count; i++) {
        x[i] = 10.0 * (double)i / (double)(count - 1);
        y[i] = 0.5 + 0.4 * sin(3 * x[i]) + 0.1 * sin(40 * x[i]);
    }
}

PlotSeries sample_line(const char *name, const double *x, const double *y, size_t count) {
    return (PlotSeries){.name = name, .x = x, .y = y, .count = count, .role = ROLE_LOCUS, .width = 3};
}

Plot sample_plot(PlotSeries *series, size_t count) {
    return (Plot){.x = {.title = "time", .unit = "s"},
                  .y = {.title = "clearance", .unit = "m"},
                  .series = series,
                  .series_count = count};
}

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

void sample_check_layout(const PlotLayout *layout) {
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

bool sample_has_text(const PlotLayout *layout, const char *text) {
    for (size_t i = 0; i < layout->sheet.caption_count; i++)
        if (strcmp(layout->sheet.captions[i].text, text) == 0)
            return true;
    return false;
}

cairo_surface_t *sample_painted(const Plot *plot, int width, int height, double unit) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, unit, unit);
    plot_paint(plot, cairo, vec2(width / unit, height / unit), THEME_PAPER);
    cairo_destroy(cairo);
    cairo_surface_flush(surface);
    return surface;
}

int sample_ink(const PlotCanvas *canvas, Vec2 place) {
    const unsigned char *pixel =
        plot_canvas_pixels(canvas) + (int)place.y * plot_canvas_stride(canvas) + 4 * (int)place.x;
    return 255 - pixel[2];
}

char *sample_written(const Plot *plot, int kind, size_t *size) {
    char path[CHECK_PATH];
    check_temporary(path, "plot-XXXXXX");
    int file = mkstemp(path);
    CHECK(file >= 0);
    close(file);
    CHECK((kind == SAMPLE_CSV
               ? plot_write_csv(plot, path)
               : plot_write_picture((CairoFileKind)kind, plot, path, &(PlotSheet){800, 500, THEME_PAPER, NULL})) == 0);
    char *bytes = text_read_file(path, 1 << 26, size);
    unlink(path);
    return bytes;
}
