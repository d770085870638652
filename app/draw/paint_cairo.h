/* Still pictures: a scene as PNG or SVG, by cairo. The same scene, size and theme give the same bytes. Files are
 * written beside and renamed. Both return 0, or errno: EINVAL for sizes that no picture has. */
#pragma once

#include "draw/palette.h"
#include "draw/scene.h"

enum { PAINT_LARGEST = 16384 /* pixels a side: cairo's coordinates end at twice that */ };

/* `width` and `height` in pixels; widths of lines and letters grow with the smaller of width / 1280 and height / 720.
 */
int paint_cairo_png(const Scene *scene, const char *path, int width, int height, Theme theme);
int paint_cairo_svg(const Scene *scene, const char *path, int width, int height, Theme theme);
