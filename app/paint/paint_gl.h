/* Moving pictures: scenes by OpenGL. The static layer is drawn once, smooth, and copied into each frame; over it comes
 * the moving layer, and over both the texts. The painter draws into a framebuffer of its own with row 0 at the top, so
 * that it needs only a current context; every call must find that context current. The same calls give the same bytes.
 *
 *     paint_gl_still    ground, grid, list, primitives, texts: the static layer
 *     paint_gl_add      more for it, as loci grow
 *     paint_gl_rewind   the first state of the static layer
 *     paint_gl_panel    a plot has changed
 *     paint_gl_frame    static layer, moving layer, texts
 *     paint_gl_read     the frame's pixels                                                                           */
#pragma once

#include "paint/gl.h"
#include "draw/layout.h"
#include "draw/palette.h"

typedef struct PaintGl PaintGl;

/* Makes a painter for pictures of width x height pixels, `unit` of them a design point, with the functions of the
 * current context, which must outlive the painter; NULL if the context has no room for such a picture. Layouts of the
 * layers must be made for a page of that size over the unit. */
PaintGl *paint_gl_create(const Gl *gl, int width, int height, double unit, Theme theme);
void paint_gl_destroy(PaintGl *paint);

/* Redraws the static layer, with empty panels. The layer may be freed afterwards. */
void paint_gl_still(PaintGl *paint, Layer ground);

/* Adds a layer made by layout_make_over on top of the static one. Its solids have no shadows. */
void paint_gl_add(PaintGl *paint, Layer more);

/* Removes all that paint_gl_add and paint_gl_panel have added to the static layer. */
void paint_gl_rewind(PaintGl *paint);

/* Copies the changed part x, y, w, h of a picture to layout->panels[index]. The picture is cairo's RGB24 or opaque
 * ARGB32, width x height pixels, one pixel per pixel of the page. */
void paint_gl_panel(PaintGl *paint, int index, const unsigned char *pixels, int width, int height, int stride, int x,
                    int y, int w, int h);

/* Draws a frame: the static layer, a layer made by layout_make_over, and all captions. */
void paint_gl_frame(PaintGl *paint, Layer moving);

/* Reads the last frame: width x height pixels of 4 bytes, blue, green, red and 255, rows from the top. */
void paint_gl_read(PaintGl *paint, unsigned char *pixels);

/* Returns the framebuffer that holds the last frame, row 0 at the top, and its size in pixels. */
GLuint paint_gl_framebuffer(const PaintGl *paint, int *width, int *height);
