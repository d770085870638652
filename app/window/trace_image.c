#include "window/trace_image.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "draw/cairo_memory.h"
#include "window/notice.h"
#include "window/plan_input.h"

enum { SIDE_MOST = 4096 /* pixels: larger pictures are scaled down */, PIXELS_MOST = 1 << 26, HEAD = 24 /* bytes */ };

/* Reads the width and height of a PNG file; false: a message says what is wrong with the file. */
static bool read_head(Window *window, const char *path, double *width, double *height) {
    unsigned char head[HEAD];
    int refusal = text_read_refusal(path);
    if (refusal) {
        notice_post(window, "%s cannot be read: %s", path, text_read_reason(refusal));
        return false;
    }
    FILE *file = fopen(path, "rb");
    size_t count = file ? fread(head, 1, HEAD, file) : 0;
    if (file)
        fclose(file);
    if (count == HEAD && memcmp(head, "\x89PNG\r\n\x1a\n", 8) == 0) {
        *width = ((double)head[16] * 256 + head[17]) * 65536 + head[18] * 256 + head[19];
        *height = ((double)head[20] * 256 + head[21]) * 65536 + head[22] * 256 + head[23];
        if (*width >= 1 && *height >= 1 && *width * *height <= PIXELS_MOST)
            return true;
        notice_post(window, "%s has too many pixels. The limit is %d million.", path, PIXELS_MOST / 1000000);
    } else if (count > 1 && head[0] == 0xff && head[1] == 0xd8) {
        notice_post(window, "%s is a JPEG file. Save it as PNG to use it.", path);
    } else {
        notice_post(window, file ? "%s is not a PNG file." : "%s cannot be read.", path);
    }
    return false;
}

/* Returns the picture on white, at most as large as graphics cards accept. */
static cairo_surface_t *shrunk(cairo_surface_t *picture, double width, double height) {
    double scale = fmin(1, SIDE_MOST / fmax(width, height));
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)fmax(1, round(scale * width)),
                                                          (int)fmax(1, round(scale * height)));
    cairo_t *cairo = cairo_create(surface);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_scale(cairo, scale, scale);
    cairo_set_source_surface(cairo, picture, 0, 0);
    cairo_paint(cairo);
    cairo_memory_end(cairo);
    cairo_surface_flush(surface);
    return surface;
}

static void load(Window *window, const char *path) {
    double width, height;
    if (!read_head(window, path, &width, &height))
        return;
    cairo_surface_t *picture = cairo_image_surface_create_from_png(path);
    if (cairo_surface_status(picture) == CAIRO_STATUS_SUCCESS) {
        cairo_surface_t *surface = shrunk(picture, width, height);
        int w = cairo_image_surface_get_width(surface), h = cairo_image_surface_get_height(surface);
        paint_gl_screen_fill(window->screen, &window->trace_image, cairo_image_surface_get_data(surface), w, h,
                             cairo_image_surface_get_stride(surface), 0, 0, w, h);
        cairo_surface_destroy(surface);
    } else {
        notice_post(window, "%s: %s", path, cairo_status_to_string(cairo_surface_status(picture)));
    }
    cairo_surface_destroy(picture);
}

void trace_image_clear(Window *window) {
    paint_gl_screen_release(window->screen, &window->trace_image);
    memory_free(window->trace_image_path);
    window->trace_image_path = NULL;
}

void trace_image_show(Window *window) {
    const Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    TraceImage image = editor ? editor_image(editor) : (TraceImage){.path = NULL};
    if (!image.path)
        return;
    if (!window->trace_image_path || strcmp(window->trace_image_path, image.path) != 0) {
        trace_image_clear(window);
        window->trace_image_path = text_copy(image.path);
        load(window, window->trace_image_path);
    }
    Vec2 corners[4];
    for (int i = 0; i < 4; i++)
        corners[i] = vec2_add(window->frame.view.low, view_layers_point(&tab->view_layers, image.corners[i]));
    ui_draw_picture(window->ui, &window->trace_image, corners, image.opacity);
}
