/* Shapes as a graphics card draws them: triangles, and rectangles in whose pixels a shader measures how far they are
 * from a line or a disc, so that edges are smooth without samples. Lengths are pixels of the page, y down. One list is
 * one call of the card and is drawn in its order. Knows no GL. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "draw/palette.h"

/* What the shader makes of a vertex: see shaders.c. */
enum { INK_FILL, INK_STROKE, INK_BALL };
enum { INK_PREVIOUS = 1, INK_NEXT = 2, INK_ROUND_BEGIN = 4, INK_ROUND_END = 8 };

typedef struct InkVertex {
    float at[3];           /* pixels, and depth from -1, near, to 1 */
    unsigned char rgba[4]; /* not multiplied by the opacity */
    float shape[4];        /* strokes: both ends; fills: pixels inwards from up to three edges */
    float beside[4];       /* strokes: the points before and behind them; balls: their dark side's colour */
    float size[4]; /* strokes: half width, radius, length before, dashes' scale; fills: half width, gap, begin of a
                      hatch */
    unsigned char kind[4]; /* which of INK_, INK_PREVIOUS and so on, the line's style, and nothing */
} InkVertex;

/* Zero is empty; ink_clear releases it. */
typedef struct Ink {
    InkVertex *vertices; /* (count) */
    unsigned *indices;   /* (index_count) three a triangle */
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
    double dash;  /* pixels that a unit of the style's pattern is long, see paint_sizes.h */
    double begun; /* pixels of the line that have been drawn: its dashes go on */
} InkPen;

/* Thin lines over a fill, from the lower left to the upper right. */
typedef struct InkHatch {
    double width, gap; /* across the line; along x from line to line */
    double begin;      /* x + y of one of them */
} InkHatch;

void ink_clear(Ink *ink);

/* A convex face without smooth edges. */
void ink_add_face(Ink *ink, const InkPoint *corners, size_t count, InkColour colour);

/* A triangle, those of its edges smooth that are borders; the smooth edge reaches half a pixel out of it. */
void ink_add_triangle(Ink *ink, const InkPoint corners[3], const bool border[3], InkColour colour,
                      const InkHatch *hatch);

/* An upright rectangle, its edges smooth. */
void ink_add_box(Ink *ink, Box box, InkColour colour);

/* A line through points: ends cut off square, or round like the dashes of its style; round joints. A closed one joins
 * its last point with its first. One that goes on from another, `begun`, begins round, so that it covers the joint. */
void ink_add_line(Ink *ink, const InkPoint *points, size_t count, bool closed, InkPen pen);

/* A disc, or the ring of that width whose middle is a circle. */
void ink_add_disc(Ink *ink, InkPoint centre, double radius, InkColour colour);
void ink_add_ring(Ink *ink, InkPoint centre, double radius, double width, InkColour colour);

/* A single line with round ends. */
void ink_add_capsule(Ink *ink, const InkPoint ends[2], InkPen pen);

/* A disc shaded like a ball from the colour to the dark side's. */
void ink_add_ball(Ink *ink, InkPoint centre, double radius, Colour bright, Colour dark);
