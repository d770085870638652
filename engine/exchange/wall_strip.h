/* The strip along a gap in a wall, and the lines that run along it. Private to the importers. */
#pragma once

#include "exchange/wall_chains.h"
#include "mechanics/broadphase.h"

enum { WALL_STRIP_PARTS = 64 };

typedef struct WallStrip {
    Vec2 from, axis;                   /* m, beginning and unit vector */
    double width, half;                /* m: extent along the axis, and on each side of it */
    double parts[WALL_STRIP_PARTS][2]; /* m, along the axis: separate stretches along which lines run */
    size_t count;
} WallStrip;

/* Returns the strip from a to b, without any lines. */
WallStrip wall_strip_between(Vec2 a, Vec2 b, double half);

/* Adds the line from a to b if it runs along the strip and within it. */
void wall_strip_cover(WallStrip *strip, Vec2 a, Vec2 b);

/* Returns the length (m) along which lines run. */
double wall_strip_length(const WallStrip *strip);

/* Returns the length (m) of the strip from a to b, relative to `origin`, along which lines of the list run. The tree
 * holds the boxes of the lines, relative to `origin`. */
double wall_strip_closed(const WallLines *lines, const Broadphase *tree, Vec2 origin, Vec2 a, Vec2 b, double half);

/* Cuts the line from a to b where it runs within a strip about the x axis of `axis`, from `low` to `high` and within
 * `half`. Returns false if no part of the line does; `part` is in fractions of the line. */
bool wall_strip_clip(Vec2 a, Vec2 b, Vec2 from, Vec2 axis, double low, double high, double half, double part[2]);
