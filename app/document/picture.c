#include "document/picture.h"

#include "paint/cairo_file.h"

#define PNG_SCALE 2.0 /* pixels per design point: sharp also at 200 % */

enum { LARGEST_SVG = 1 << 20 /* bytes, thousands of lines: a browser redraws larger files slowly at every scroll */ };

/* A picture and its theme, for cairo_file_bytes. */
typedef struct Painting {
    const Picture *picture;
    Theme theme;
} Painting;

static void paint(struct _cairo *cairo, Vec2 page, const void *what) {
    const Painting *painting = what;
    (void)page; /* the picture's size in whole pixels */
    painting->picture->paint(painting->picture->context, cairo, painting->picture->size, painting->theme);
}

static Bytes as_kind(CairoFileKind kind, const Picture *picture, double scale, Theme theme) {
    Bytes bytes = {0};
    Vec2 size = vec2_scale(picture->size, scale);
    cairo_file_bytes(kind, &bytes, (int)ceil(size.x), (int)ceil(size.y), scale, paint, &(Painting){picture, theme});
    return bytes;
}

PictureFile picture_file(const Picture *picture, Theme theme) {
    Bytes bytes = as_kind(CAIRO_FILE_SVG, picture, 1, theme);
    if (bytes.size <= LARGEST_SVG)
        return (PictureFile){"image/svg+xml", (unsigned char *)bytes.at, bytes.size};
    memory_free(bytes.at);
    bytes = as_kind(CAIRO_FILE_PNG, picture, PNG_SCALE, theme);
    return (PictureFile){"image/png", (unsigned char *)bytes.at, bytes.size};
}

void picture_clear(PictureFile *file) {
    memory_free(file->bytes);
    *file = (PictureFile){0};
}
