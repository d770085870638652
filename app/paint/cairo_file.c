#include "paint/cairo_file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file_write.h"
#include "base/memory.h"

const char *const cairo_file_endings[] = {[CAIRO_FILE_PNG] = "png", [CAIRO_FILE_SVG] = "svg", [CAIRO_FILE_PDF] = "pdf"};

static cairo_status_t store_bytes(void *context, const unsigned char *data, unsigned length) {
    bytes_add(context, data, length);
    return CAIRO_STATUS_SUCCESS;
}

/* cairo numbers its pages by the surfaces that the process has made. */
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

static cairo_surface_t *create_surface(CairoFileKind kind, Bytes *bytes, int width, int height) {
    cairo_surface_t *surface;
    switch (kind) {
    case CAIRO_FILE_SVG:
        surface = cairo_svg_surface_create_for_stream(store_bytes, bytes, width, height);
        cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
        return surface;
    case CAIRO_FILE_PDF:
        surface = cairo_pdf_surface_create_for_stream(store_bytes, bytes, width, height);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
        return surface;
    case CAIRO_FILE_PNG:
        break;
    }
    return cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
}

static int status_error(cairo_status_t status) {
    return status == CAIRO_STATUS_SUCCESS ? 0 : status == CAIRO_STATUS_NO_MEMORY ? ENOMEM : EINVAL;
}

bool cairo_file_pdf_is_whole(const Bytes *pdf) {
    /* "startxref", the table's offset, "%%EOF"; the table: "xref", "0 COUNT", and 20 bytes for each object */
    static const char start[] = "startxref\n", head[] = "xref\n0 ";
    const size_t tail = 40, entry = 20;
    const char *found = pdf->size > tail ? strstr(pdf->at + pdf->size - tail, start) : NULL;
    size_t table = found ? strtoul(found + strlen(start), NULL, 10) : pdf->size;
    if (table >= pdf->size || strncmp(pdf->at + table, head, strlen(head)) != 0)
        return false;
    char *entries;
    size_t count = strtoul(pdf->at + table + strlen(head), &entries, 10);
    if (*entries != '\n' || count > (pdf->size - (size_t)(entries + 1 - pdf->at)) / entry)
        return false;
    for (size_t i = 1; i < count; i++) {
        size_t at = strtoul(entries + 1 + entry * i, NULL, 10);
        char name[32];
        int length = snprintf(name, sizeof name, "%zu 0 obj", i);
        if (at >= pdf->size || strncmp(pdf->at + at, name, (size_t)length) != 0)
            return false;
    }
    return true;
}

/* Paints, and makes cairo write all of its output. */
static int paint_surface(CairoFileKind kind, cairo_surface_t *surface, Bytes *bytes, Vec2 page, double unit,
                         CairoFilePaint *paint, const void *what) {
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, unit, unit);
    paint(cairo, page, what);
    int error = status_error(cairo_status(cairo));
    cairo_destroy(cairo);
    if (!error && kind == CAIRO_FILE_PNG)
        error = status_error(cairo_surface_write_to_png_stream(surface, store_bytes, bytes));
    cairo_surface_finish(surface);
    error = error ? error : status_error(cairo_surface_status(surface));
    return !error && kind == CAIRO_FILE_PDF && !cairo_file_pdf_is_whole(bytes) ? ENOMEM : error;
}

int cairo_file_bytes(CairoFileKind kind, Bytes *bytes, int width, int height, double unit, CairoFilePaint *paint,
                     const void *what) {
    if (width <= 0 || height <= 0 || width > CAIRO_FILE_LARGEST || height > CAIRO_FILE_LARGEST)
        return EINVAL;
    cairo_surface_t *surface = create_surface(kind, bytes, width, height);
    int error = paint_surface(kind, surface, bytes, vec2(width / unit, height / unit), unit, paint, what);
    cairo_surface_destroy(surface);
    if (kind == CAIRO_FILE_SVG)
        remove_surface_number(bytes);
    return error;
}

int cairo_file_write(CairoFileKind kind, const char *path, int width, int height, double unit, CairoFilePaint *paint,
                     const void *what) {
    Bytes bytes = {0};
    int error = cairo_file_bytes(kind, &bytes, width, height, unit, paint, what);
    if (!error)
        error = file_write_bytes(path, bytes.at, bytes.size);
    memory_free(bytes.at);
    return error;
}
