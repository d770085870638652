/* Still pictures: scenes by cairo, as vectors or pixels. The same scene, size and theme give the same bytes. */
#pragma once

#include "paint/cairo_file.h"
#include "draw/layout.h"
#include "draw/palette.h"
#include "draw/scene.h"

struct _cairo; /* cairo's own name of cairo_t */

/* Paints layers on a cairo context whose unit is the design point. In a raised view only flat primitives are painted.
 */
void paint_cairo_layers(struct _cairo *cairo, const Layer *layers, size_t count, Theme theme);

/* Paints the parts of any page: its faint lines; its texts and the line samples among them. */
void paint_cairo_grid(struct _cairo *cairo, const Layout *layout, Theme theme);
void paint_cairo_captions(struct _cairo *cairo, const Layout *layout, Theme theme);

/* Sets the width, dashes, caps and joins of lines of a style. */
void paint_cairo_line(struct _cairo *cairo, LineStyle style, double width);

/* Lays out a scene for a page of this size, in design points, from the origin of the context, and paints it. */
void paint_cairo_scene(struct _cairo *cairo, const Scene *scene, Vec2 page, Theme theme);

/* Lays out a scene for a picture of that size and writes a file, see cairo_file.h; line widths and text sizes grow
 * with the smaller of width / 1280 and height / 720. Returns 0, or errno. */
int paint_cairo_file(CairoFileKind kind, const Scene *scene, const char *path, int width, int height, Theme theme);
