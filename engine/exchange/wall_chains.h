/* Joins single lines into walls: two lines of equal thickness and height that alone meet end to end become one wall,
 * without a point where they continue straight. Private to the importers. */
#pragma once

#include "exchange/house_builder.h"

typedef struct WallLine {
    Vec2 a, b;
    double thickness, height;
} WallLine;

#define WALL_CHAINS_TOLERANCE 1e-3 /* m: ends closer than this meet */

/* Adds the walls of `count` lines; a duplicate counts once. Returns the number of duplicates. */
size_t wall_chains_add(HouseBuilder *builder, const WallLine *lines, size_t count);

/* A growing list of lines. A zeroed list is empty; memory_free(lines.list) releases it. */
typedef struct WallLines {
    WallLine *list; /* (count) */
    size_t count, capacity;
} WallLines;

void wall_chains_append(WallLines *lines, WallLine line);

enum { WALL_CHAINS_ARC = 64 };

/* Approximates an arc about `centre`, from `from` through `sweep` rad counter-clockwise, by straight lines within 1
 * cm of it. Stores the points after `from`, the last at the arc's end, and returns their number. */
size_t wall_chains_arc(Vec2 centre, Vec2 from, double sweep, Vec2 points[WALL_CHAINS_ARC]);
