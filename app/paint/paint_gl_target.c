#include "paint/paint_gl_target.h"

#include <stddef.h>

static void make_colour(PaintGlTarget *target, const Gl *gl) {
    if (target->samples) {
        gl->GenRenderbuffers(1, &target->colour);
        gl->BindRenderbuffer(GL_RENDERBUFFER, target->colour);
        gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, target->samples, GL_RGBA8, target->width, target->height);
        gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target->colour);
        return;
    }
    gl->GenTextures(1, &target->colour);
    gl->BindTexture(GL_TEXTURE_2D, target->colour);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    /* the byte order in which pixels are read back: reading then copies rows */
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, target->width, target->height, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                   NULL);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->colour, 0);
}

bool paint_gl_target_make(PaintGlTarget *target, const Gl *gl, int width, int height, int samples) {
    *target = (PaintGlTarget){.width = width, .height = height, .samples = samples};
    gl->GenFramebuffers(1, &target->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    make_colour(target, gl);
    gl->GenRenderbuffers(1, &target->depth);
    gl->BindRenderbuffer(GL_RENDERBUFFER, target->depth);
    gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, width, height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, target->depth);
    return gl->GetError() == GL_NO_ERROR && gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void paint_gl_target_clear(PaintGlTarget *target, const Gl *gl) {
    if (target->samples)
        gl->DeleteRenderbuffers(1, &target->colour);
    else
        gl->DeleteTextures(1, &target->colour);
    gl->DeleteRenderbuffers(1, &target->depth);
    gl->DeleteFramebuffers(1, &target->framebuffer);
    *target = (PaintGlTarget){0};
}

void paint_gl_target_copy(const PaintGlTarget *from, const PaintGlTarget *to, const Gl *gl, GLbitfield buffers) {
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, from->framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, to->framebuffer);
    gl->BlitFramebuffer(0, 0, from->width, from->height, 0, 0, to->width, to->height, buffers, GL_NEAREST);
}
