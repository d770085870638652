/* A framebuffer to draw on, of the size of the picture. */
#pragma once

#include "paint/gl.h"

typedef struct PaintGlTarget {
    GLuint framebuffer, colour, depth;
    int width, height, samples; /* samples 0: colour is a texture; otherwise both are renderbuffers */
} PaintGlTarget;

/* False when the context has no room for it. */
bool paint_gl_target_make(PaintGlTarget *target, const Gl *gl, int width, int height, int samples);
void paint_gl_target_clear(PaintGlTarget *target, const Gl *gl);

/* Copies `buffers`, colour or depth or both; samples are averaged. */
void paint_gl_target_copy(const PaintGlTarget *from, const PaintGlTarget *to, const Gl *gl, GLbitfield buffers);
