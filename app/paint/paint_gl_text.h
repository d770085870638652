/* Texts on a graphics card: pango draws each one once into the atlas, a picture that holds many of them, and it is
 * copied from there. A full atlas is emptied, so that memory stays constant however often the texts change. */
#pragma once

#include "paint/gl.h"
#include "draw/layout.h"
#include "draw/palette.h"

typedef struct PaintGlText PaintGlText;

/* Makes texts for a canvas of that many pixels, `unit` per design point; the context must outlive them. */
PaintGlText *paint_gl_text_create(const Gl *gl, int width, int height, double unit);
void paint_gl_text_destroy(PaintGlText *text);

/* Adds the text of a caption, or the halo around it, for paint_gl_text_draw; draws at once if the atlas is full. */
void paint_gl_text_add(PaintGlText *text, const Caption *caption, Colour colour);
void paint_gl_text_add_halo(PaintGlText *text, const Caption *caption, Colour colour);

/* Draws the added texts on the current framebuffer. */
void paint_gl_text_draw(PaintGlText *text);
