/* The OpenGL of a window besides the painter of scenes: pictures as textures, and triangles for what lies over them.
 * Draws on the window's own framebuffer, whose row 0 is at the bottom; places are pixels, y down. Every call must find
 * the context current. */
#pragma once

#include <stddef.h>

#include "paint/gl.h"
#include "paint/paint_gl.h"

typedef struct PaintGlScreen PaintGlScreen;

/* The functions of the current context must outlive it. */
PaintGlScreen *paint_gl_screen_create(const Gl *gl);
void paint_gl_screen_destroy(PaintGlScreen *screen);

/* Draws on a picture of its own from now on: for tests, which have no window. */
void paint_gl_screen_leave_window(PaintGlScreen *screen);

/* Begins a frame of width x height pixels, filled with one colour. */
void paint_gl_screen_begin(PaintGlScreen *screen, int width, int height, Colour ground);

/* Copies the last frame of a painter to x, y (its upper left corner). */
void paint_gl_screen_show(PaintGlScreen *screen, const PaintGl *paint, int x, int y);

/* Fills a part of the window with one colour: quicker than triangles. */
void paint_gl_screen_box(PaintGlScreen *screen, Colour colour, int left, int top, int width, int height);

/* Reads the pixels of the window: width x height of 4 bytes, blue, green, red and 255, rows from the top. */
void paint_gl_screen_read(PaintGlScreen *screen, unsigned char *pixels);

/* A picture in the memory of the graphics card. Zero is none. */
typedef struct ScreenTexture {
    GLuint name;
    int width, height; /* pixels */
} ScreenTexture;

/* Copies the part x, y, w, h of a picture in cairo's RGB24 (width x height pixels, `stride` bytes a row) to a texture;
 * a texture of another size is remade, whole. */
void paint_gl_screen_fill(PaintGlScreen *screen, ScreenTexture *texture, const unsigned char *pixels, int width,
                          int height, int stride, int x, int y, int w, int h);

/* Does the same for one byte per pixel, its opacity: for glyphs. */
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
