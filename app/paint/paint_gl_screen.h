/* What a window needs of OpenGL besides the painter of scenes: pictures as textures, and triangles for what lies over
 * them. Draws on the window's own framebuffer, whose row 0 is at the bottom; places are pixels, y down. Every call must
 * find the context current. */
#pragma once

#include <stddef.h>

#include "paint/gl.h"
#include "paint/paint_gl.h"

typedef struct PaintGlScreen PaintGlScreen;

/* The functions of the current context must outlive it. */
PaintGlScreen *paint_gl_screen_create(const Gl *gl);
void paint_gl_screen_destroy(PaintGlScreen *screen);

/* Where there is no window, as in tests: from now on it draws on a picture of its own. */
void paint_gl_screen_leave_window(PaintGlScreen *screen);

/* Begins a frame of width x height pixels, all of one colour. */
void paint_gl_screen_begin(PaintGlScreen *screen, int width, int height, Colour ground);

/* Copies a painter's last frame, with its upper left corner at x, y. */
void paint_gl_screen_show(PaintGlScreen *screen, const PaintGl *paint, int x, int y);

/* A part of the window in one colour: quicker than triangles. */
void paint_gl_screen_box(PaintGlScreen *screen, Colour colour, int left, int top, int width, int height);

/* The window's pixels as they are now: width x height of 4 bytes, blue, green, red and 255, rows from the top. */
void paint_gl_screen_read(PaintGlScreen *screen, unsigned char *pixels);

/* A picture in the graphics card's memory. Zero is none. */
typedef struct ScreenTexture {
    GLuint name;
    int width, height; /* pixels */
} ScreenTexture;

/* Makes the part x, y, w, h of a texture that of a picture of cairo's RGB24 (width x height pixels, `stride` bytes a
 * row); a texture of another size is made anew, whole. */
void paint_gl_screen_fill(PaintGlScreen *screen, ScreenTexture *texture, const unsigned char *pixels, int width,
                          int height, int stride, int x, int y, int w, int h);

/* The same of one byte a pixel, how opaque it is: for letters. */
void paint_gl_screen_fill_mask(PaintGlScreen *screen, ScreenTexture *texture, const unsigned char *pixels, int width,
                               int height);
void paint_gl_screen_release(PaintGlScreen *screen, ScreenTexture *texture);

typedef struct ScreenVertex {
    float x, y, u, v;
    unsigned char rgba[4];
} ScreenVertex;

/* Draws triangles, three indices each, within a part of the window. */
void paint_gl_screen_mesh(PaintGlScreen *screen, const ScreenVertex *vertices, size_t vertex_count,
                          const unsigned short *indices, size_t index_count, const ScreenTexture *texture, int left,
                          int top, int width, int height);
