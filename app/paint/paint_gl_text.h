/* Words on a graphics card: each is drawn once, by pango, into a picture that holds many of them, the atlas, and copied
 * from there. When the atlas is full it starts anew, so that memory stays as it is however often the words change. */
#pragma once

#include "paint/gl.h"
#include "draw/layout.h"
#include "draw/palette.h"

typedef struct PaintGlText PaintGlText;

/* For a canvas of that many pixels, `unit` a design point; the context must outlive it. */
PaintGlText *paint_gl_text_create(const Gl *gl, int width, int height, double unit);
void paint_gl_text_destroy(PaintGlText *text);

/* Adds a caption's words, or the halo around them, to what paint_gl_text_draw draws; draws by itself when the atlas is
 * full. */
void paint_gl_text_add(PaintGlText *text, const Caption *caption, Colour colour);
void paint_gl_text_add_halo(PaintGlText *text, const Caption *caption, Colour colour);

/* Draws what was added, on the current framebuffer. */
void paint_gl_text_draw(PaintGlText *text);
