/* Text: its size and how it is drawn. DejaVu Sans without hinting, so that a picture twice as large is the same
 * picture. */
#pragma once

#include <stdbool.h>

#include "base/vec2.h"

/* Returns a copy of the text for pictures and pages: characters that act are shown by their number (base/visible.h),
 * and codes that are not characters are replaced. The caller frees it with memory_free. */
char *text_plain(const char *text);

/* False if the system has no font for Latin letters, so that pictures show boxes in their place. */
bool text_has_fonts(void);

struct _PangoLayout; /* pango's own name of PangoLayout */

/* Returns an empty layout for text of that size and weight; `typed`: in a fixed-width font; g_object_unref releases
 * it. */
struct _PangoLayout *text_layout(double size, bool bold, bool typed);

/* Returns width and height of one line of text of `size`, in the unit of `size`. */
Vec2 text_extent(const char *text, double size, bool bold);

struct _cairo; /* cairo's own name of cairo_t */

/* Draws the text in the current colour, centred at `centre`. */
void text_show(struct _cairo *cairo, const char *text, double size, bool bold, Vec2 centre);

/* Adds the outlines of the glyphs to the current path. */
void text_path(struct _cairo *cairo, const char *text, double size, bool bold, Vec2 centre);
