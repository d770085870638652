/* Still pictures: scenes by cairo, as vectors or pixels. The same scene, size and theme give the same bytes. */
#pragma once

#include "paint/cairo_file.h"
#include "draw/layout.h"
#include "draw/palette.h"
#include "draw/scene.h"

struct _cairo; /* cairo's own name of cairo_t */

/* Paints layers on a cairo context whose unit is the design point. Of a raised view what is flat is painted. */
void paint_cairo_layers(struct _cairo *cairo, const Layer *layers, size_t count, Theme theme);

/* What any laid out page has: its faint lines; its words, and the pieces of line among them. */
void paint_cairo_grid(struct _cairo *cairo, const Layout *layout, Theme theme);
void paint_cairo_captions(struct _cairo *cairo, const Layout *layout, Theme theme);

/* Sets the width, the dashes, the caps and the joins that lines of a style have. */
void paint_cairo_line(struct _cairo *cairo, LineStyle style, double width);

/* Lays a scene out for a page of this size, in design points, from the origin of the context on, and paints it. */
void paint_cairo_scene(struct _cairo *cairo, const Scene *scene, Vec2 page, Theme theme);

/* Lays a scene out for a picture of that size and makes a file of it, see cairo_file.h; widths of lines and letters
 * grow with the smaller of width / 1280 and height / 720. 0, or errno. */
int paint_cairo_file(CairoFileKind kind, const Scene *scene, const char *path, int width, int height, Theme theme);
