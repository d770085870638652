#include "document/picture.h"

#include <cairo-svg.h>
#include <string.h>

#include "document/bytes.h"

#define PNG_SCALE 2.0 /* pixels a design point: sharp also where letters are shown at 200 % */

enum { LARGEST_SVG = 1 << 20 /* bytes: many thousand lines, which a browser draws anew at every scroll */ };

static void paint(const Picture *picture, cairo_surface_t *surface, double scale, Theme theme) {
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, scale, scale);
    picture->paint(picture->context, cairo, picture->size, theme);
    cairo_destroy(cairo);
}

/* cairo names a page by how many surfaces the process has made: without that number the same picture is the same
 * bytes. */
static void remove_surface_number(Bytes *bytes) {
    static const char name[] = "<g id=\"surface";
    char *found = bytes->size ? strstr(bytes->at, name) : NULL;
    if (!found)
        return;
    char *number = found + sizeof name - 1;
    size_t digits = strspn(number, "0123456789");
    memmove(number, number + digits, bytes->size - (size_t)(number - bytes->at) - digits + 1);
    bytes->size -= digits;
}

static Bytes as_svg(const Picture *picture, Theme theme) {
    Bytes bytes = {0};
    cairo_surface_t *surface =
        cairo_svg_surface_create_for_stream(bytes_keep, &bytes, picture->size.x, picture->size.y);
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    paint(picture, surface, 1, theme);
    cairo_surface_destroy(surface);
    remove_surface_number(&bytes);
    return bytes;
}

static Bytes as_png(const Picture *picture, Theme theme) {
    Bytes bytes = {0};
    Vec2 size = vec2_scale(picture->size, PNG_SCALE);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)ceil(size.x), (int)ceil(size.y));
    paint(picture, surface, PNG_SCALE, theme);
    cairo_surface_write_to_png_stream(surface, bytes_keep, &bytes);
    cairo_surface_destroy(surface);
    return bytes;
}

PictureFile picture_file(const Picture *picture, Theme theme) {
    Bytes bytes = as_svg(picture, theme);
    const char *type = "image/svg+xml";
    if (bytes.size > LARGEST_SVG) {
        memory_free(bytes.at);
        bytes = as_png(picture, theme);
        type = "image/png";
    }
    return (PictureFile){type, (unsigned char *)bytes.at, bytes.size};
}

void picture_clear(PictureFile *file) {
    memory_free(file->bytes);
    *file = (PictureFile){0};
}
