/* Shapes as a graphics card draws them: triangles, and rectangles in whose pixels a shader measures the distance to a
 * line or a disc, so that edges are smooth without multisampling. Lengths are pixels of the page, y down. A list is
 * one draw call and is drawn in its order. This file does not know GL. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "draw/palette.h"

/* The input of the shader for a vertex: see shaders.c. */
enum { INK_FILL, INK_STROKE, INK_BALL };
enum { INK_PREVIOUS = 1, INK_NEXT = 2, INK_ROUND_BEGIN = 4, INK_ROUND_END = 8 };

typedef struct InkVertex {
    float at[3];           /* pixels, and depth from -1, near, to 1 */
    unsigned char rgba[4]; /* not premultiplied */
    float shape[4];        /* strokes: both ends; fills: pixels inwards from at most three edges */
    float beside[4];       /* strokes: the points before and behind them; balls: the colour of the dark side */
    float size[4]; /* strokes: half width, radius, length before, dashes' scale; fills: half width, gap, begin of a
                      hatch */
    unsigned char kind[4]; /* one of INK_, INK_PREVIOUS and so on, the line's style, and unused */
} InkVertex;

/* Zero is empty; ink_clear releases it. */
typedef struct Ink {
    InkVertex *vertices; /* (count) */
    unsigned *indices;   /* (index_count) three per triangle */
    size_t count, capacity, index_count, index_capacity;
} Ink;

typedef struct InkPoint {
    Vec2 at;
    double depth;
} InkPoint;

typedef struct InkColour {
    Colour colour;
    double opacity; /* 0 to 1 */
} InkColour;

typedef struct InkPen {
    InkColour colour;
    double width;
    LineStyle style;
    double dash;  /* pixels per unit of the style's pattern, see paint_sizes.h */
    double begun; /* pixels of the line that are drawn already: its dashes continue */
} InkPen;

/* Thin lines over a fill, rising to the right. */
typedef struct InkHatch {
    double width, gap; /* across the line; along x from line to line */
    double begin;      /* x + y of one of them */
} InkHatch;

void ink_clear(Ink *ink);

/* Adds a convex face without smooth edges. */
void ink_add_face(Ink *ink, const InkPoint *corners, size_t count, InkColour colour);

/* Adds a triangle, smooth at those of its edges that are borders; a smooth edge reaches half a pixel out of the
 * triangle. */
void ink_add_triangle(Ink *ink, const InkPoint corners[3], const bool border[3], InkColour colour,
                      const InkHatch *hatch);

/* Adds an upright rectangle with smooth edges. */
void ink_add_box(Ink *ink, Box box, InkColour colour);

/* Adds a line through points: ends cut off square, or round like the dashes of its style; round joints. A closed line
 * joins its last point with its first. A line that continues another one, `begun`, starts round, so that it covers the
 * joint. */
void ink_add_line(Ink *ink, const InkPoint *points, size_t count, bool closed, InkPen pen);

/* Adds a disc, or a ring of that width along a circle. */
void ink_add_disc(Ink *ink, InkPoint centre, double radius, InkColour colour);
void ink_add_ring(Ink *ink, InkPoint centre, double radius, double width, InkColour colour);

/* Adds a single line with round ends. */
void ink_add_capsule(Ink *ink, const InkPoint ends[2], InkPen pen);

/* Adds a disc shaded like a ball, from the colour to that of the dark side. */
void ink_add_ball(Ink *ink, InkPoint centre, double radius, Colour bright, Colour dark);
