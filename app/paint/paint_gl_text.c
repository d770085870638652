#include "paint/paint_gl_text.h"

#include <cairo.h>
#include <stddef.h>
#include <stdint.h>

#include "base/digest.h"
#include "base/memory.h"
#include "paint/paint_sizes.h"
#include "paint/shaders.h"
#include "draw/cairo_memory.h"
#include "draw/text.h"

enum {
    MARGIN = 2, /* texels round a text: glyphs reach a little out of their extent */
    SMALLEST = 512,
};

typedef struct Stamp {
    uint64_t key; /* of the text, its size, weight and halo: 64 bits, so that no two texts share a key */
    int x, y, width, height;
} Stamp;

typedef struct Corner {
    float at[4]; /* pixels of the canvas, texels of the atlas */
    unsigned char rgba[4];
} Corner;

struct PaintGlText {
    const Gl *gl;
    double unit;
    int width, height; /* of the atlas, texels */
    int x, y, row;     /* where the next text goes, and the height of its row */
    Stamp *stamps;     /* (count) */
    size_t count, capacity;
    Corner *corners; /* (4 quad_count) */
    unsigned *indices;
    size_t quad_count, corner_capacity, index_capacity;
    GLuint program, texture, array, buffers[2];
};

static void make_buffers(PaintGlText *text) {
    const Gl *gl = text->gl;
    gl->GenVertexArrays(1, &text->array);
    gl->BindVertexArray(text->array);
    gl->GenBuffers(2, text->buffers);
    gl->BindBuffer(GL_ARRAY_BUFFER, text->buffers[0]);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, text->buffers[1]);
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Corner), (const void *)offsetof(Corner, at));
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Corner), (const void *)offsetof(Corner, rgba));
    gl->EnableVertexAttribArray(0);
    gl->EnableVertexAttribArray(1);
}

static void make_texture(PaintGlText *text) {
    const Gl *gl = text->gl;
    gl->GenTextures(1, &text->texture);
    gl->BindTexture(GL_TEXTURE_2D, text->texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, text->width, text->height, 0, GL_RED, GL_UNSIGNED_BYTE, NULL);
}

PaintGlText *paint_gl_text_create(const Gl *gl, int width, int height, double unit) {
    static const char *const attributes[] = {"at", "rgba", NULL};
    PaintGlText *text = memory_zeroed(1, sizeof *text);
    *text = (PaintGlText){.gl = gl,
                          .unit = unit,
                          .width = width > SMALLEST ? width : SMALLEST,
                          .height = height > SMALLEST ? height : SMALLEST};
    text->program = gl_program(gl, shaders_text_vertex, shaders_text_fragment, attributes);
    gl->UseProgram(text->program);
    gl->Uniform2f(gl->GetUniformLocation(text->program, "canvas"), (float)width, (float)height);
    gl->Uniform2f(gl->GetUniformLocation(text->program, "atlas"), (float)text->width, (float)text->height);
    make_buffers(text);
    make_texture(text);
    return text;
}

void paint_gl_text_destroy(PaintGlText *text) {
    const Gl *gl = text->gl;
    gl->DeleteProgram(text->program);
    gl->DeleteTextures(1, &text->texture);
    gl->DeleteVertexArrays(1, &text->array);
    gl->DeleteBuffers(2, text->buffers);
    memory_free(text->stamps);
    memory_free(text->corners);
    memory_free(text->indices);
    memory_free(text);
}

void paint_gl_text_draw(PaintGlText *text) {
    const Gl *gl = text->gl;
    if (!text->quad_count)
        return;
    gl->UseProgram(text->program);
    gl->BindTexture(GL_TEXTURE_2D, text->texture);
    gl->BindVertexArray(text->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, text->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(4 * text->quad_count * sizeof *text->corners), text->corners,
                   GL_STREAM_DRAW);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(6 * text->quad_count * sizeof *text->indices), text->indices,
                   GL_STREAM_DRAW);
    gl->DrawElements(GL_TRIANGLES, (GLsizei)(6 * text->quad_count), GL_UNSIGNED_INT, NULL);
    text->quad_count = 0;
}

/* The atlas -------------------------------------------------------------------------------------------------------- */

static uint64_t stamp_key(const Caption *caption, bool halo) {
    uint64_t key = digest_mix(DIGEST_START, caption->size + (caption->bold ? 0.25 : 0) + (halo ? 0.125 : 0));
    for (const char *c = caption->text; *c; c++)
        key = digest_chain(key, (unsigned char)*c);
    return digest_mix(key, 0);
}

/* Finds room for a text; false if the atlas is full. */
static bool place_stamp(PaintGlText *text, Stamp *stamp) {
    if (text->x + stamp->width > text->width) {
        text->x = 0;
        text->y += text->row;
        text->row = 0;
    }
    if (text->y + stamp->height > text->height)
        return false;
    stamp->x = text->x;
    stamp->y = text->y;
    text->x += stamp->width;
    text->row = stamp->height > text->row ? stamp->height : text->row;
    return true;
}

static void begin_atlas(PaintGlText *text) {
    paint_gl_text_draw(text);
    text->count = 0;
    text->x = text->y = text->row = 0;
}

/* Draws the text, or a line round its glyphs, in the middle of a picture of the text's size. */
static void upload_stamp(const PaintGlText *text, const Stamp *stamp, const Caption *caption, bool halo) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, stamp->width, stamp->height);
    cairo_t *cairo = cairo_create(surface);
    Vec2 middle = {stamp->width / 2.0 / text->unit, stamp->height / 2.0 / text->unit};
    cairo_scale(cairo, text->unit, text->unit);
    if (halo) {
        text_path(cairo, caption->text, caption->size, caption->bold, middle);
        cairo_set_line_width(cairo, PAINT_HALO_WIDTH);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_stroke(cairo);
    } else {
        text_show(cairo, caption->text, caption->size, caption->bold, middle);
    }
    cairo_memory_end(cairo);
    cairo_surface_flush(surface);
    const Gl *gl = text->gl;
    gl->BindTexture(GL_TEXTURE_2D, text->texture);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, cairo_image_surface_get_stride(surface));
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, stamp->x, stamp->y, stamp->width, stamp->height, GL_RED, GL_UNSIGNED_BYTE,
                      cairo_image_surface_get_data(surface));
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    cairo_surface_destroy(surface);
}

static const Stamp *find_stamp(PaintGlText *text, const Caption *caption, bool halo) {
    uint64_t key = stamp_key(caption, halo);
    for (size_t i = 0; i < text->count; i++)
        if (text->stamps[i].key == key)
            return &text->stamps[i];
    Vec2 extent = vec2_scale(text_extent(caption->text, caption->size, caption->bold), text->unit);
    double margin = 2 * (MARGIN + (halo ? PAINT_HALO_WIDTH / 2 * text->unit : 0));
    Stamp stamp = {.key = key,
                   .width = (int)fmin(ceil(extent.x + margin), text->width),
                   .height = (int)fmin(ceil(extent.y + margin), text->height)};
    if (!place_stamp(text, &stamp)) {
        begin_atlas(text);
        place_stamp(text, &stamp);
    }
    upload_stamp(text, &stamp, caption, halo);
    text->stamps = memory_reserve(text->stamps, &text->capacity, text->count + 1, sizeof *text->stamps);
    text->stamps[text->count] = stamp;
    return &text->stamps[text->count++];
}

/* Rectangles --------------------------------------------------------------------------------------------------------*/

static void add_stamp(PaintGlText *text, const Caption *caption, bool halo, Colour colour, double opacity) {
    static const unsigned order[] = {0, 1, 2, 0, 2, 3};
    const Stamp *stamp = find_stamp(text, caption, halo);
    size_t first = 4 * text->quad_count;
    text->corners = memory_reserve(text->corners, &text->corner_capacity, first + 4, sizeof *text->corners);
    text->indices =
        memory_reserve(text->indices, &text->index_capacity, 6 * (text->quad_count + 1), sizeof *text->indices);
    float width = (float)(caption->turned ? stamp->height : stamp->width);
    float height = (float)(caption->turned ? stamp->width : stamp->height);
    /* on whole pixels: keeps glyphs crisp */
    float left = roundf((float)(caption->centre.x * text->unit) - width / 2);
    float top = roundf((float)(caption->centre.y * text->unit) - height / 2);
    for (int i = 0; i < 4; i++) {
        bool right = i == 1 || i == 2, low = i >= 2;
        bool across = caption->turned ? !low : right, down = caption->turned ? right : low;
        Corner *corner = &text->corners[first + (size_t)i];
        *corner = (Corner){.at = {left + (right ? width : 0), top + (low ? height : 0),
                                  (float)(stamp->x + (across ? stamp->width : 0)),
                                  (float)(stamp->y + (down ? stamp->height : 0))},
                           .rgba = {(unsigned char)lrint(255 * colour.red), (unsigned char)lrint(255 * colour.green),
                                    (unsigned char)lrint(255 * colour.blue), (unsigned char)lrint(255 * opacity)}};
    }
    for (size_t i = 0; i < 6; i++)
        text->indices[6 * text->quad_count + i] = (unsigned)first + order[i];
    text->quad_count++;
}

void paint_gl_text_add(PaintGlText *text, const Caption *caption, Colour colour) {
    add_stamp(text, caption, false, colour, 1);
}

void paint_gl_text_add_halo(PaintGlText *text, const Caption *caption, Colour colour) {
    add_stamp(text, caption, true, colour, PAINT_HALO_OPACITY);
}
