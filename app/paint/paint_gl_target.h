/* A framebuffer of the size of the picture. */
#pragma once

#include "paint/gl.h"

typedef struct PaintGlTarget {
    GLuint framebuffer, colour, depth;
    int width, height, samples; /* samples 0: colour is a texture; otherwise both are renderbuffers */
} PaintGlTarget;

/* Returns false if the context has no room for it. */
bool paint_gl_target_make(PaintGlTarget *target, const Gl *gl, int width, int height, int samples);
void paint_gl_target_clear(PaintGlTarget *target, const Gl *gl);

/* Copies `buffers`, colour or depth or both; averages samples. */
void paint_gl_target_copy(const PaintGlTarget *from, const PaintGlTarget *to, const Gl *gl, GLbitfield buffers);
