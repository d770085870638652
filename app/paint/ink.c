#include "paint/ink.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "paint/paint_sizes.h"

#define FAR_INSIDE 1e4 /* pixels: no edge is near */
#define FRINGE 0.5     /* pixels of a smooth edge outside the shape */
#define REACH 0.51     /* pixels by which a rectangle exceeds its shape: includes every pixel that is partly covered */
#define LEAST_STEP 0.3 /* pixels: nearer points of a line count as one */
#define LEAST_APART 1e-3 /* pixels, for the ends of a line */

void ink_clear(Ink *ink) {
    memory_free(ink->vertices);
    memory_free(ink->indices);
    *ink = (Ink){0};
}

static unsigned char channel(double value) {
    return (unsigned char)lrint(255 * real_clamp(value, 0, 1));
}

static InkVertex vertex_of(int kind, InkColour colour) {
    return (InkVertex){.rgba = {channel(colour.colour.red), channel(colour.colour.green), channel(colour.colour.blue),
                                channel(colour.opacity)},
                       .kind = {(unsigned char)kind}};
}

static void set_place(InkVertex *vertex, InkPoint point) {
    vertex->at[0] = (float)point.at.x;
    vertex->at[1] = (float)point.at.y;
    vertex->at[2] = (float)point.depth;
}

/* Reserves room for more vertices and triangles; returns the index of the first new vertex. */
static unsigned reserve(Ink *ink, size_t vertices, size_t indices) {
    ink->vertices = memory_reserve(ink->vertices, &ink->capacity, ink->count + vertices, sizeof *ink->vertices);
    ink->indices = memory_reserve(ink->indices, &ink->index_capacity, ink->index_count + indices, sizeof *ink->indices);
    return (unsigned)ink->count;
}

static void add_corners(Ink *ink, const InkVertex corners[3]) {
    unsigned first = reserve(ink, 3, 3);
    memcpy(ink->vertices + ink->count, corners, 3 * sizeof *corners);
    ink->count += 3;
    for (unsigned i = 0; i < 3; i++)
        ink->indices[ink->index_count++] = first + i;
}

/* Adds four corners, in order round the rectangle. */
static void add_quad(Ink *ink, const InkVertex corners[4]) {
    static const unsigned order[] = {0, 1, 2, 0, 2, 3};
    unsigned first = reserve(ink, 4, 6);
    memcpy(ink->vertices + ink->count, corners, 4 * sizeof *corners);
    ink->count += 4;
    for (size_t i = 0; i < 6; i++)
        ink->indices[ink->index_count++] = first + order[i];
}

/* Fills -------------------------------------------------------------------------------------------------------------*/

static InkVertex fill_vertex(InkColour colour, const InkHatch *hatch) {
    InkVertex vertex = vertex_of(INK_FILL, colour);
    for (int i = 0; i < 4; i++)
        vertex.shape[i] = FAR_INSIDE;
    if (hatch) {
        vertex.size[0] = (float)(hatch->width / 2);
        vertex.size[1] = (float)hatch->gap;
        vertex.size[2] = (float)hatch->begin;
    }
    return vertex;
}

void ink_add_face(Ink *ink, const InkPoint *corners, size_t count, InkColour colour) {
    if (colour.opacity <= 0)
        return; /* a transparent face would still hide others by depth */
    unsigned first = reserve(ink, count, 3 * count);
    for (size_t i = 0; i < count; i++) {
        ink->vertices[ink->count] = fill_vertex(colour, NULL);
        set_place(&ink->vertices[ink->count++], corners[i]);
    }
    for (unsigned i = 2; i < count; i++) {
        unsigned triangle[] = {first, first + i - 1, first + i};
        memcpy(ink->indices + ink->index_count, triangle, sizeof triangle);
        ink->index_count += 3;
    }
}

/* Adds the half pixel outside an edge; `out` is the unit direction there. */
static void add_fringe(Ink *ink, InkPoint a, InkPoint b, Vec2 out, InkVertex vertex) {
    InkVertex quad[4] = {vertex, vertex, vertex, vertex};
    InkPoint outer[2] = {{vec2_along(b.at, FRINGE, out), b.depth}, {vec2_along(a.at, FRINGE, out), a.depth}};
    set_place(&quad[0], a);
    set_place(&quad[1], b);
    set_place(&quad[2], outer[0]);
    set_place(&quad[3], outer[1]);
    for (int i = 0; i < 4; i++)
        quad[i].shape[0] = i < 2 ? 0 : (float)-FRINGE;
    add_quad(ink, quad);
}

void ink_add_triangle(Ink *ink, const InkPoint corners[3], const bool border[3], InkColour colour,
                      const InkHatch *hatch) {
    InkVertex vertex = fill_vertex(colour, hatch), vertices[3] = {vertex, vertex, vertex};
    for (int i = 0; i < 3; i++)
        set_place(&vertices[i], corners[i]);
    for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3, opposite = (i + 2) % 3;
        Vec2 along = vec2_unit(vec2_sub(corners[next].at, corners[i].at)), in = vec2_left(along);
        double height = vec2_dot(vec2_sub(corners[opposite].at, corners[i].at), in);
        if (!border[i] || height == 0)
            continue;
        vertices[i].shape[i] = vertices[next].shape[i] = 0;
        vertices[opposite].shape[i] = (float)fabs(height);
        add_fringe(ink, corners[i], corners[next], vec2_scale(in, height > 0 ? -1 : 1), vertex);
    }
    add_corners(ink, vertices);
}

void ink_add_box(Ink *ink, Box box, InkColour colour) {
    static const bool first[] = {true, true, false}, second[] = {false, true, true};
    InkPoint corners[] = {{box.low, 0}, {{box.high.x, box.low.y}, 0}, {box.high, 0}, {{box.low.x, box.high.y}, 0}};
    ink_add_triangle(ink, corners, first, colour, NULL);
    ink_add_triangle(ink, (InkPoint[]){corners[0], corners[2], corners[3]}, second, colour, NULL);
}

/* Strokes -----------------------------------------------------------------------------------------------------------*/

static void set_pair(float pair[2], Vec2 at) {
    pair[0] = (float)at.x;
    pair[1] = (float)at.y;
}

/* Adds a rectangle round the segment; the depth beyond the ends is extrapolated. */
static void add_segment(Ink *ink, InkPoint a, InkPoint b, InkVertex vertex) {
    Vec2 along = vec2_unit(vec2_sub(b.at, a.at));
    double length = vec2_distance(a.at, b.at), reach = vertex.size[0] + vertex.size[1] + REACH;
    if (length == 0)
        along = vec2(1, 0);
    double slope = length > 0 ? (b.depth - a.depth) / length * reach : 0;
    Vec2 ahead = vec2_scale(along, reach), side = vec2_left(ahead);
    set_pair(vertex.shape, a.at);
    set_pair(vertex.shape + 2, b.at);
    InkVertex quad[4] = {vertex, vertex, vertex, vertex};
    InkPoint from = {vec2_sub(a.at, ahead), a.depth - slope}, to = {vec2_add(b.at, ahead), b.depth + slope};
    set_place(&quad[0], (InkPoint){vec2_sub(from.at, side), from.depth});
    set_place(&quad[1], (InkPoint){vec2_sub(to.at, side), to.depth});
    set_place(&quad[2], (InkPoint){vec2_add(to.at, side), to.depth});
    set_place(&quad[3], (InkPoint){vec2_add(from.at, side), from.depth});
    add_quad(ink, quad);
}

/* Returns the index of the next point that is not too near; `count` if there is none. The last point always counts. */
static size_t next_point(const InkPoint *points, size_t count, size_t i) {
    for (size_t k = i + 1; k < count; k++)
        if (vec2_distance(points[k].at, points[i].at) >= (k + 1 < count ? LEAST_STEP : LEAST_APART))
            return k;
    return count;
}

typedef struct Walk {
    const InkPoint *points;
    size_t count;
    bool closed;
} Walk;

/* Returns the point behind `i`; SIZE_MAX behind the last point of an open line. */
static size_t walk_next(const Walk *walk, size_t i) {
    size_t next = next_point(walk->points, walk->count, i);
    if (next < walk->count)
        return next;
    return walk->closed && i > 0 ? 0 : SIZE_MAX;
}

/* Returns the last point that a closed line joins with its first. */
static size_t walk_last(const Walk *walk) {
    size_t last = 0;
    for (size_t next = walk_next(walk, 0); next != SIZE_MAX && next != 0; next = walk_next(walk, next))
        last = next;
    return last;
}

void ink_add_line(Ink *ink, const InkPoint *points, size_t count, bool closed, InkPen pen) {
    while (closed && count > 1 && vec2_distance(points[count - 1].at, points[0].at) < LEAST_APART)
        count--;
    Walk walk = {points, count, closed && count > 2};
    if (count < 2 || pen.width <= 0)
        return;
    InkVertex vertex = vertex_of(INK_STROKE, pen.colour);
    vertex.size[0] = (float)(pen.width / 2);
    vertex.size[3] = (float)pen.dash;
    vertex.kind[2] = (unsigned char)pen.style;
    int ends = paint_is_round(pen.style) ? INK_ROUND_BEGIN | INK_ROUND_END : pen.begun > 0 ? INK_ROUND_BEGIN : 0;
    size_t last = walk.closed ? walk_last(&walk) : SIZE_MAX, previous = last;
    double length = pen.begun;
    for (size_t i = 0, next; (next = walk_next(&walk, i)) != SIZE_MAX; previous = i, i = next) {
        size_t after = next || !walk.closed ? walk_next(&walk, next) : walk_next(&walk, 0);
        vertex.size[2] = (float)length;
        vertex.kind[1] =
            (unsigned char)(ends | (previous != SIZE_MAX ? INK_PREVIOUS : 0) | (after != SIZE_MAX ? INK_NEXT : 0));
        set_pair(vertex.beside, points[previous != SIZE_MAX ? previous : i].at);
        set_pair(vertex.beside + 2, points[after != SIZE_MAX ? after : next].at);
        add_segment(ink, points[i], points[next], vertex);
        length += vec2_distance(points[i].at, points[next].at);
        if (next == 0)
            break;
    }
}

static InkVertex round_vertex(int kind, double half, double radius, InkColour colour) {
    InkVertex vertex = vertex_of(kind, colour);
    vertex.size[0] = (float)half;
    vertex.size[1] = (float)radius;
    vertex.kind[1] = INK_ROUND_BEGIN | INK_ROUND_END;
    return vertex;
}

void ink_add_disc(Ink *ink, InkPoint centre, double radius, InkColour colour) {
    add_segment(ink, centre, centre, round_vertex(INK_STROKE, radius, 0, colour));
}

void ink_add_ring(Ink *ink, InkPoint centre, double radius, double width, InkColour colour) {
    add_segment(ink, centre, centre, round_vertex(INK_STROKE, width / 2, radius, colour));
}

void ink_add_capsule(Ink *ink, const InkPoint ends[2], InkPen pen) {
    add_segment(ink, ends[0], ends[1], round_vertex(INK_STROKE, pen.width / 2, 0, pen.colour));
}

void ink_add_ball(Ink *ink, InkPoint centre, double radius, Colour bright, Colour dark) {
    InkVertex vertex = round_vertex(INK_BALL, radius, 0, (InkColour){bright, 1});
    vertex.beside[0] = (float)dark.red;
    vertex.beside[1] = (float)dark.green;
    vertex.beside[2] = (float)dark.blue;
    add_segment(ink, centre, centre, vertex);
}
