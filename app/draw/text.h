/* TextStyle: how large words are, and how they are drawn. DejaVu Sans without hinting, so that a picture twice as large
 * is the same picture. */
#pragma once

#include <stdbool.h>

#include "base/vec2.h"

/* The words with a sign of replacement for each code that neither XML nor a page has a place for: control characters
 * but the end of a line, and codes that are none. New; memory_free it. */
char *text_plain(const char *text);

struct _PangoLayout; /* pango's own name of PangoLayout */

/* An empty layout for letters of that size and weight, `typed`: of one width; g_object_unref releases it. */
struct _PangoLayout *text_layout(double size, bool bold, bool typed);

/* Width and height of one line of words with letters of `size`, in the unit of `size`. */
Vec2 text_extent(const char *text, double size, bool bold);

struct _cairo; /* cairo's own name of cairo_t */

/* Draws the words in the current colour, their middle at `centre`. */
void text_show(struct _cairo *cairo, const char *text, double size, bool bold, Vec2 centre);

/* Adds the letters' outlines to the current path. */
void text_path(struct _cairo *cairo, const char *text, double size, bool bold, Vec2 centre);
