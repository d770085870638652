/* Picture files from any painting with cairo. The same painting gives the same bytes: the clock and the count of
 * earlier pictures are taken out of cairo's output. Files are written to a temporary file, then renamed. */
#pragma once

#include <stdbool.h>

#include "base/vec2.h"
#include "paint/bytes.h"

typedef enum CairoFileKind { CAIRO_FILE_PNG, CAIRO_FILE_SVG, CAIRO_FILE_PDF } CairoFileKind;

/* How the names of such files end, by their kind, without the dot. */
extern const char *const cairo_file_endings[];

enum { CAIRO_FILE_LARGEST = 16384 /* pixels a side: cairo's coordinates end at twice that */ };

struct _cairo; /* cairo's own name of cairo_t */

/* Paints on a page of that size in design points, the unit of the context. */
typedef void CairoFilePaint(struct _cairo *cairo, Vec2 page, const void *what);

/* Writes a picture of `width` x `height` pixels, of 1/72 inch in a PDF; `unit` of them are a design point. Returns 0,
 * or errno: EINVAL for invalid sizes. */
int cairo_file_write(CairoFileKind kind, const char *path, int width, int height, double unit, CairoFilePaint *paint,
                     const void *what);

/* Does the same into empty bytes. */
int cairo_file_bytes(CairoFileKind kind, Bytes *bytes, int width, int height, double unit, CairoFilePaint *paint,
                     const void *what);

/* True if a PDF by cairo holds every object that its table names. cairo leaves out a font for which it has no memory,
 * and reports success. */
bool cairo_file_pdf_is_whole(const Bytes *pdf);
