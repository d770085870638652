/* Single lines joined into walls: where just two lines of the same thickness and height meet end to end, they are one
 * wall, and what goes straight on there has no point. Only for the importers. */
#pragma once

#include "exchange/house_builder.h"

typedef struct WallLine {
    Vec2 a, b;
    double thickness, height;
} WallLine;

#define WALL_CHAINS_TOLERANCE 1e-3 /* m: ends this near to each other meet */

/* Adds the walls of (count) lines; a line that is there twice counts once. */
void wall_chains_add(HouseBuilder *builder, const WallLine *lines, size_t count);

/* Lines that are collected. Zero is none; memory_free(lines.list) releases them. */
typedef struct WallLines {
    WallLine *list; /* (count) */
    size_t count, capacity;
} WallLines;

void wall_chains_keep(WallLines *lines, WallLine line);

enum { WALL_CHAINS_ARC = 64 };

/* Straight lines for an arc about `centre` from `from` on by `sweep` rad, counter-clockwise, that stay within a
 * centimetre of it: the points after `from`, the last at the arc's end. Returns how many. */
size_t wall_chains_arc(Vec2 centre, Vec2 from, double sweep, Vec2 points[WALL_CHAINS_ARC]);
