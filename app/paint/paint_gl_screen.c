#include "paint/paint_gl_screen.h"

#include <assert.h>
#include <stddef.h>
#include <string.h>

#include "base/memory.h"
#include "paint/paint_gl_target.h"
#include "paint/shaders.h"

struct PaintGlScreen {
    const Gl *gl;
    int width, height;  /* of the frame */
    bool windowless;    /* draws on `own` */
    PaintGlTarget own;  /* row 0 at the bottom, as in a window */
    GLuint framebuffer; /* of the window or of `own` */
    GLuint program, array, buffers[2];
    GLint canvas;
};

/* Making ----------------------------------------------------------------------------------------------------------- */

static void make_buffers(PaintGlScreen *screen) {
    const Gl *gl = screen->gl;
    gl->GenVertexArrays(1, &screen->array);
    gl->BindVertexArray(screen->array);
    gl->GenBuffers(2, screen->buffers);
    gl->BindBuffer(GL_ARRAY_BUFFER, screen->buffers[0]);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, screen->buffers[1]);
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(ScreenVertex), (const void *)offsetof(ScreenVertex, x));
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ScreenVertex),
                            (const void *)offsetof(ScreenVertex, rgba));
    gl->EnableVertexAttribArray(0);
    gl->EnableVertexAttribArray(1);
}

PaintGlScreen *paint_gl_screen_create(const Gl *gl) {
    static const char *const attributes[] = {"at", "rgba", NULL};
    PaintGlScreen *screen = memory_zeroed(1, sizeof *screen);
    *screen = (PaintGlScreen){.gl = gl};
    screen->program = gl_program(gl, shaders_screen_vertex, shaders_screen_fragment, attributes);
    screen->canvas = gl->GetUniformLocation(screen->program, "canvas");
    make_buffers(screen);
    return screen;
}

void paint_gl_screen_leave_window(PaintGlScreen *screen) {
    screen->windowless = true;
}

void paint_gl_screen_destroy(PaintGlScreen *screen) {
    const Gl *gl = screen->gl;
    if (screen->own.framebuffer)
        paint_gl_target_clear(&screen->own, gl);
    gl->DeleteProgram(screen->program);
    gl->DeleteVertexArrays(1, &screen->array);
    gl->DeleteBuffers(2, screen->buffers);
    memory_free(screen);
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

static void make_own(PaintGlScreen *screen, int width, int height) {
    if (screen->own.framebuffer && screen->own.width == width && screen->own.height == height)
        return;
    if (screen->own.framebuffer)
        paint_gl_target_clear(&screen->own, screen->gl);
    bool good = paint_gl_target_make(&screen->own, screen->gl, width, height, 0);
    assert(good);
    (void)good;
    screen->framebuffer = screen->own.framebuffer;
}

void paint_gl_screen_begin(PaintGlScreen *screen, int width, int height, Colour ground) {
    const Gl *gl = screen->gl;
    if (screen->windowless)
        make_own(screen, width, height);
    screen->width = width;
    screen->height = height;
    gl->BindFramebuffer(GL_FRAMEBUFFER, screen->framebuffer);
    gl->Disable(GL_SCISSOR_TEST);
    gl->ClearColor((GLfloat)ground.red, (GLfloat)ground.green, (GLfloat)ground.blue, 1);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

void paint_gl_screen_show(PaintGlScreen *screen, const PaintGl *paint, int x, int y) {
    const Gl *gl = screen->gl;
    int width, height, top = screen->height - y;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, paint_gl_framebuffer(paint, &width, &height));
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, screen->framebuffer);
    gl->Disable(GL_SCISSOR_TEST);
    gl->BlitFramebuffer(0, 0, width, height, x, top, x + width, top - height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void paint_gl_screen_box(PaintGlScreen *screen, Colour colour, int left, int top, int width, int height) {
    const Gl *gl = screen->gl;
    if (width <= 0 || height <= 0)
        return;
    gl->BindFramebuffer(GL_FRAMEBUFFER, screen->framebuffer);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(left, screen->height - top - height, width, height);
    gl->ClearColor((GLfloat)colour.red, (GLfloat)colour.green, (GLfloat)colour.blue, 1);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->Disable(GL_SCISSOR_TEST);
}

void paint_gl_screen_read(PaintGlScreen *screen, unsigned char *pixels) {
    const Gl *gl = screen->gl;
    size_t stride = 4 * (size_t)screen->width, height = (size_t)screen->height;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, screen->framebuffer);
    gl->ReadPixels(0, 0, screen->width, screen->height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
    unsigned char *row = memory_zeroed(1, stride);
    for (size_t i = 0; i < height / 2; i++) {
        unsigned char *upper = pixels + i * stride, *lower = pixels + (height - 1 - i) * stride;
        memcpy(row, upper, stride);
        memcpy(upper, lower, stride);
        memcpy(lower, row, stride);
    }
    memory_free(row);
    for (size_t i = 3; i < stride * height; i += 4)
        pixels[i] = 255;
    gl_check(gl);
}

/* Textures --------------------------------------------------------------------------------------------------------- */

static void make_texture(const Gl *gl, ScreenTexture *texture, int width, int height, GLint filter) {
    if (!texture->name)
        gl->GenTextures(1, &texture->name);
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    *texture = (ScreenTexture){texture->name, width, height};
}

void paint_gl_screen_fill(PaintGlScreen *screen, ScreenTexture *texture, const unsigned char *pixels, int width,
                          int height, int stride, int x, int y, int w, int h) {
    const Gl *gl = screen->gl;
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, stride / 4);
    if (!texture->name || texture->width != width || texture->height != height) {
        make_texture(gl, texture, width, height, GL_LINEAR);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_ONE); /* RGB24 leaves its fourth byte undefined */
        gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
    } else if (w > 0 && h > 0) {
        gl->BindTexture(GL_TEXTURE_2D, texture->name);
        gl->TexSubImage2D(GL_TEXTURE_2D, 0, x, y, w, h, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                          pixels + (ptrdiff_t)y * stride + 4 * (ptrdiff_t)x);
    }
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void paint_gl_screen_fill_mask(PaintGlScreen *screen, ScreenTexture *texture, const unsigned char *pixels, int width,
                               int height) {
    static const GLint white[] = {GL_ONE, GL_ONE, GL_ONE, GL_RED};
    static const GLenum channels[] = {GL_TEXTURE_SWIZZLE_R, GL_TEXTURE_SWIZZLE_G, GL_TEXTURE_SWIZZLE_B,
                                      GL_TEXTURE_SWIZZLE_A};
    const Gl *gl = screen->gl;
    make_texture(gl, texture, width, height, GL_NEAREST);
    for (int i = 0; i < 4; i++)
        gl->TexParameteri(GL_TEXTURE_2D, channels[i], white[i]);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, pixels);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void paint_gl_screen_release(PaintGlScreen *screen, ScreenTexture *texture) {
    if (texture->name)
        screen->gl->DeleteTextures(1, &texture->name);
    *texture = (ScreenTexture){0};
}

/* Triangles -------------------------------------------------------------------------------------------------------- */

void paint_gl_screen_mesh(PaintGlScreen *screen, const ScreenVertex *vertices, size_t vertex_count,
                          const unsigned short *indices, size_t index_count, const ScreenTexture *texture, int left,
                          int top, int width, int height) {
    const Gl *gl = screen->gl;
    if (!index_count || width <= 0 || height <= 0)
        return;
    gl->BindFramebuffer(GL_FRAMEBUFFER, screen->framebuffer);
    gl->Viewport(0, 0, screen->width, screen->height);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_STENCIL_TEST);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(left, screen->height - top - height, width, height);
    gl->UseProgram(screen->program);
    gl->Uniform2f(screen->canvas, (GLfloat)screen->width, (GLfloat)screen->height);
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
    gl->BindVertexArray(screen->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, screen->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(vertex_count * sizeof *vertices), vertices, GL_STREAM_DRAW);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(index_count * sizeof *indices), indices, GL_STREAM_DRAW);
    gl->DrawElements(GL_TRIANGLES, (GLsizei)index_count, GL_UNSIGNED_SHORT, NULL);
    gl->Disable(GL_SCISSOR_TEST);
}
