#include "paint/paint_gl.h"

#include <stddef.h>

#include "paint/drawing_caption.h"
#include "paint/drawing_pen.h"
#include "paint/drawing_solid.h"
#include "paint/paint_gl_target.h"
#include "paint/paint_gl_text.h"
#include "paint/paint_sizes.h"
#include "paint/shaders.h"

enum {
    SAMPLES = 4 /* samples per pixel of the static layer where faces meet; more cost time without a visible gain */
};

struct PaintGl {
    const Gl *gl;
    int width, height;
    PaintGlTarget ground, still,
        frame; /* ground: the first state of the static layer, stored when something is added */
    GLuint shapes_program, faces_program, array, buffers[2];
    Drawing drawing; /* reused for each layer */
    Ink shapes;      /* around texts */
    PaintGlText *text;
    Box inside; /* of the page: clips the scene */
    Box panels[SCENE_PANELS];
    bool raised;
    Caption *captions; /* (caption_count) of the static layer that the moving layer may hide: drawn in each frame */
    Sample *samples;   /* (sample_count) */
    size_t caption_count, caption_capacity, sample_count, sample_capacity;
    size_t first_captions, first_samples; /* the number of them in the first state of the static layer */
    bool added;                           /* something was added since */
    Arena arena;                          /* holds their texts */
};

/* Making ----------------------------------------------------------------------------------------------------------- */

static void set_attribute(const Gl *gl, GLuint location, GLint size, size_t offset) {
    gl->VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(InkVertex), (const void *)offset);
    gl->EnableVertexAttribArray(location);
}

static void make_buffers(PaintGl *paint) {
    const Gl *gl = paint->gl;
    gl->GenVertexArrays(1, &paint->array);
    gl->BindVertexArray(paint->array);
    gl->GenBuffers(2, paint->buffers);
    gl->BindBuffer(GL_ARRAY_BUFFER, paint->buffers[0]);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, paint->buffers[1]);
    set_attribute(gl, 0, 3, offsetof(InkVertex, at));
    set_attribute(gl, 1, 4, offsetof(InkVertex, shape));
    set_attribute(gl, 2, 4, offsetof(InkVertex, beside));
    set_attribute(gl, 3, 4, offsetof(InkVertex, size));
    gl->VertexAttribPointer(4, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(InkVertex),
                            (const void *)offsetof(InkVertex, rgba));
    gl->EnableVertexAttribArray(4);
    gl->VertexAttribIPointer(5, 4, GL_UNSIGNED_BYTE, sizeof(InkVertex), (const void *)offsetof(InkVertex, kind));
    gl->EnableVertexAttribArray(5);
}

/* Makes the program current. */
static void set_canvas(const PaintGl *paint, GLuint program) {
    paint->gl->UseProgram(program);
    paint->gl->Uniform2f(paint->gl->GetUniformLocation(program, "canvas"), (GLfloat)paint->width,
                         (GLfloat)paint->height);
}

static void make_programs(PaintGl *paint) {
    static const char *const attributes[] = {"at", "shape", "beside", "size", "rgba", "kind", NULL};
    const Gl *gl = paint->gl;
    GLfloat dashes[LINE_STYLES][4];
    for (int style = 0; style < LINE_STYLES; style++)
        for (int i = 0; i < 4; i++)
            dashes[style][i] = (GLfloat)paint_dashes[style][i];
    paint->faces_program = gl_program(gl, shaders_face_vertex, shaders_face_fragment, attributes);
    set_canvas(paint, paint->faces_program);
    GLuint program = paint->shapes_program = gl_program(gl, shaders_ink_vertex, shaders_ink_fragment, attributes);
    set_canvas(paint, program);
    gl->Uniform4fv(gl->GetUniformLocation(program, "dashes"), LINE_STYLES, dashes[0]);
    gl->Uniform3f(gl->GetUniformLocation(program, "light"), drawing_solid_light[0], drawing_solid_light[1],
                  drawing_solid_light[2]);
}

PaintGl *paint_gl_create(const Gl *gl, int width, int height, double unit, Theme theme) {
    PaintGl *paint = memory_zeroed(1, sizeof *paint);
    *paint = (PaintGl){.gl = gl, .width = width, .height = height};
    paint->drawing.theme = theme;
    paint->drawing.unit = unit;
    bool good = paint_gl_target_make(&paint->still, gl, width, height, 0);
    good = paint_gl_target_make(&paint->frame, gl, width, height, 0) && good;
    good = paint_gl_target_make(&paint->ground, gl, width, height, 0) && good;
    make_programs(paint);
    make_buffers(paint);
    paint->text = paint_gl_text_create(gl, width, height, paint->drawing.unit);
    if (good && gl->GetError() == GL_NO_ERROR)
        return paint;
    paint_gl_destroy(paint);
    while (gl->GetError() != GL_NO_ERROR) /* the next painter starts without a program */
        continue;
    return NULL;
}

void paint_gl_destroy(PaintGl *paint) {
    const Gl *gl = paint->gl;
    paint_gl_text_destroy(paint->text);
    paint_gl_target_clear(&paint->still, gl);
    paint_gl_target_clear(&paint->frame, gl);
    paint_gl_target_clear(&paint->ground, gl);
    gl->DeleteProgram(paint->shapes_program);
    gl->DeleteProgram(paint->faces_program);
    gl->DeleteVertexArrays(1, &paint->array);
    gl->DeleteBuffers(2, paint->buffers);
    drawing_clear(&paint->drawing);
    ink_clear(&paint->shapes);
    memory_free(paint->captions);
    memory_free(paint->samples);
    arena_clear(&paint->arena);
    memory_free(paint);
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

static void begin(const PaintGl *paint, const PaintGlTarget *target) {
    const Gl *gl = paint->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    gl->Viewport(0, 0, paint->width, paint->height);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->Disable(GL_SCISSOR_TEST);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_STENCIL_TEST);
}

static void draw_ink(const PaintGl *paint, const Ink *ink, GLuint program) {
    const Gl *gl = paint->gl;
    if (!ink->index_count)
        return;
    gl->UseProgram(program);
    gl->BindVertexArray(paint->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, paint->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(ink->count * sizeof *ink->vertices), ink->vertices, GL_STREAM_DRAW);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(ink->index_count * sizeof *ink->indices), ink->indices,
                   GL_STREAM_DRAW);
    gl->DrawElements(GL_TRIANGLES, (GLsizei)ink->index_count, GL_UNSIGNED_INT, NULL);
}

static void confine(const PaintGl *paint) {
    double unit = paint->drawing.unit;
    int left = (int)lrint(paint->inside.low.x * unit), top = (int)lrint(paint->inside.low.y * unit);
    int right = (int)lrint(paint->inside.high.x * unit), bottom = (int)lrint(paint->inside.high.y * unit);
    paint->gl->Enable(GL_SCISSOR_TEST);
    paint->gl->Scissor(left, top, right - left, bottom - top);
}

/* Draws the primitives of a layer within the frame: see Drawing. */
static void draw_layer(PaintGl *paint, Layer layer) {
    const Gl *gl = paint->gl;
    drawing_reset(&paint->drawing);
    drawing_add(&paint->drawing, layer);
    confine(paint);
    if (paint->raised)
        gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LEQUAL);
    gl->DepthMask(GL_FALSE);
    draw_ink(paint, &paint->drawing.floor, paint->shapes_program);
    gl->Enable(GL_STENCIL_TEST);
    gl->StencilFunc(GL_EQUAL, 0, 0xFF);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    draw_ink(paint, &paint->drawing.shadows, paint->shapes_program);
    gl->Disable(GL_STENCIL_TEST);
    gl->DepthMask(GL_TRUE);
    draw_ink(paint, &paint->drawing.faces, paint->faces_program);
    draw_ink(paint, &paint->drawing.balls, paint->shapes_program);
    gl->DepthMask(GL_FALSE);
    draw_ink(paint, &paint->drawing.over, paint->shapes_program);
    gl->DepthMask(GL_TRUE);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_SCISSOR_TEST);
}

static void flush_shapes(PaintGl *paint) {
    draw_ink(paint, &paint->shapes, paint->shapes_program);
    paint->shapes.count = paint->shapes.index_count = 0;
}

static void draw_caption(PaintGl *paint, const Caption *caption) {
    if (caption->shape != LABEL_BARE) {
        paint_gl_text_draw(paint->text);
        drawing_caption_add_shape(&paint->drawing, &paint->shapes, caption);
        flush_shapes(paint);
    }
    if (caption->halo)
        paint_gl_text_add_halo(paint->text, caption, palette_colour(paint->drawing.theme, caption->fill));
    paint_gl_text_add(paint->text, caption, drawing_caption_ink(&paint->drawing, caption));
}

static void draw_captions(PaintGl *paint, const Caption *captions, size_t caption_count, const Sample *samples,
                          size_t sample_count) {
    for (size_t i = 0; i < caption_count; i++)
        if (captions[i].leader)
            drawing_caption_add_leader(&paint->drawing, &paint->shapes, &captions[i]);
    for (size_t i = 0; i < sample_count; i++)
        drawing_caption_add_sample(&paint->drawing, &paint->shapes, &samples[i]);
    flush_shapes(paint);
    for (size_t i = 0; i < caption_count; i++)
        draw_caption(paint, &captions[i]);
    paint_gl_text_draw(paint->text);
}

/* Paper, and the list's panel with a rule around it; then the grid. */
static void draw_ground(PaintGl *paint, const Layout *layout) {
    Drawing *drawing = &paint->drawing;
    Ink *ink = &paint->shapes;
    InkPen rule = drawing_pen_make(drawing, drawing_pen_colour(drawing, ROLE_GRID, 1), LINE_SOLID, PAINT_RULE_WIDTH);
    Vec2 low = layout->list.low, high = layout->list.high;
    InkPoint corners[] = {drawing_pen_page(drawing, low), drawing_pen_page(drawing, vec2(high.x, low.y)),
                          drawing_pen_page(drawing, high), drawing_pen_page(drawing, vec2(low.x, high.y))};
    Colour paper = palette_colour(drawing->theme, ROLE_PAPER);
    paint->gl->ClearColor((GLfloat)paper.red, (GLfloat)paper.green, (GLfloat)paper.blue, 1);
    paint->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    ink_add_box(ink, drawing_pen_box(drawing, layout->list), drawing_pen_colour(drawing, ROLE_PANEL, 1));
    ink_add_line(ink, corners, 4, true, rule);
    drawing_pen_segment(drawing, ink, vec2(0, layout->band.high.y), vec2(layout->page.x, layout->band.high.y), rule);
    for (size_t i = 0; i < layout->grid_count; i++)
        drawing_pen_segment(drawing, ink, layout->grid[2 * i], layout->grid[2 * i + 1], rule);
    flush_shapes(paint);
}

/* The static layer ------------------------------------------------------------------------------------------------- */

static void forget_captions(PaintGl *paint) {
    paint->caption_count = paint->sample_count = 0;
    arena_clear(&paint->arena);
}

/* Stores the captions and samples that the moving layer may hide, or the others. */
static void select_captions(PaintGl *paint, const Layout *layout, bool inside) {
    for (size_t i = 0; i < layout->caption_count; i++) {
        paint->captions = memory_reserve(paint->captions, &paint->caption_capacity, paint->caption_count + 1,
                                         sizeof *paint->captions);
        Caption *kept = &paint->captions[paint->caption_count];
        *kept = layout->captions[i];
        kept->text = arena_text(&paint->arena, kept->text);
        paint->caption_count += box_holds(paint->inside, kept->centre) == inside;
    }
    for (size_t i = 0; i < layout->sample_count; i++) {
        paint->samples =
            memory_reserve(paint->samples, &paint->sample_capacity, paint->sample_count + 1, sizeof *paint->samples);
        paint->samples[paint->sample_count] = layout->samples[i];
        paint->sample_count += box_holds(paint->inside, layout->samples[i].from) == inside;
    }
}

/* Draws the static layer on the target; where faces meet, with several samples per pixel. */
static void draw_still(PaintGl *paint, Layer ground) {
    const Gl *gl = paint->gl;
    PaintGlTarget fine = {0};
    bool sampled = paint->raised && paint_gl_target_make(&fine, gl, paint->width, paint->height, SAMPLES);
    begin(paint, sampled ? &fine : &paint->still);
    draw_ground(paint, ground.layout);
    draw_layer(paint, ground);
    if (sampled)
        paint_gl_target_copy(&fine, &paint->still, gl, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    paint_gl_target_clear(&fine, gl);
}

void paint_gl_still(PaintGl *paint, Layer ground) {
    const Layout *layout = ground.layout;
    paint->inside = layout->frame;
    paint->raised = layout->view.raised;
    for (int i = 0; i < SCENE_PANELS; i++)
        paint->panels[i] = layout->panels[i];
    draw_still(paint, ground);
    forget_captions(paint);
    select_captions(paint, layout, false);
    begin(paint, &paint->still);
    draw_captions(paint, paint->captions, paint->caption_count, paint->samples, paint->sample_count);
    forget_captions(paint);
    select_captions(paint, layout, true);
    paint->first_captions = paint->caption_count;
    paint->first_samples = paint->sample_count;
    paint->added = false;
    gl_check(paint->gl);
}

/* Returns the buffers that pictures are made of: only the raised view has depths. */
static GLbitfield buffers_of(const PaintGl *paint) {
    return paint->raised ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT;
}

/* Stores the first state of the static layer before the first addition. */
static void store_ground(PaintGl *paint) {
    if (!paint->added)
        paint_gl_target_copy(&paint->still, &paint->ground, paint->gl, buffers_of(paint));
    paint->added = true;
}

void paint_gl_rewind(PaintGl *paint) {
    if (paint->added)
        paint_gl_target_copy(&paint->ground, &paint->still, paint->gl, buffers_of(paint));
    paint->caption_count = paint->first_captions;
    paint->sample_count = paint->first_samples;
    paint->added = false;
}

void paint_gl_add(PaintGl *paint, Layer more) {
    store_ground(paint);
    begin(paint, &paint->still);
    draw_layer(paint, more);
    select_captions(paint, more.layout, true);
}

static int clamped(int value, int low, int high) {
    return value < low ? low : value > high ? high : value;
}

void paint_gl_panel(PaintGl *paint, int index, const unsigned char *pixels, int width, int height, int stride, int x,
                    int y, int w, int h) {
    const Gl *gl = paint->gl;
    Vec2 corner = vec2_scale(paint->panels[index].low, paint->drawing.unit);
    int left = (int)lrint(corner.x), top = (int)lrint(corner.y);
    int right = clamped(x + w, 0, width < paint->width - left ? width : paint->width - left);
    int bottom = clamped(y + h, 0, height < paint->height - top ? height : paint->height - top);
    if (right <= x || bottom <= y)
        return;
    store_ground(paint);
    gl->BindTexture(GL_TEXTURE_2D, paint->still.colour);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, stride / 4);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, left + x, top + y, right - x, bottom - y, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                      pixels + (ptrdiff_t)y * stride + 4 * (ptrdiff_t)x);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

void paint_gl_frame(PaintGl *paint, Layer moving) {
    const Gl *gl = paint->gl;
    begin(paint, &paint->frame);
    paint_gl_target_copy(&paint->still, &paint->frame, gl, buffers_of(paint));
    begin(paint, &paint->frame);
    if (paint->raised)
        gl->Clear(GL_STENCIL_BUFFER_BIT);
    draw_layer(paint, moving);
    draw_captions(paint, paint->captions, paint->caption_count, paint->samples, paint->sample_count);
    draw_captions(paint, moving.layout->captions, moving.layout->caption_count, moving.layout->samples,
                  moving.layout->sample_count);
}

void paint_gl_read(PaintGl *paint, unsigned char *pixels) {
    const Gl *gl = paint->gl;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, paint->frame.framebuffer);
    gl->ReadPixels(0, 0, paint->width, paint->height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
    gl_check(gl);
}

GLuint paint_gl_framebuffer(const PaintGl *paint, int *width, int *height) {
    *width = paint->width;
    *height = paint->height;
    return paint->frame.framebuffer;
}
