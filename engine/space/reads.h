/* Records the cells and lists of faces that were read: an answer holds as long as none of them changes. One thread
 * writes a record. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

enum { READS_TILE = 8 /* points of a grid, along either side of the tiles in which reads are noted */ };

typedef struct Reads {
    int tile_nx, tile_ny;
    unsigned char *tiles; /* (tile_ny x tile_nx) 1: a point of the tile, or one next to it above or to the right */
    Box *boxes; /* (list_count) m: no face of the list outside of its box made a difference; empty: none did */
    size_t list_count;
    bool beyond; /* True if more was read than is noted here */
} Reads;

/* Begins with nothing read of a grid of nx by ny points and of as many lists. reads_free releases it. */
Reads reads_begin(int nx, int ny, size_t list_count);
void reads_free(Reads *reads);

/* Notes that a point was read, perhaps with those next to it above and to the right. */
static inline void reads_note_point(Reads *reads, int i, int j) {
    reads->tiles[(size_t)(j / READS_TILE) * (size_t)reads->tile_nx + (size_t)(i / READS_TILE)] = 1;
}

/* Notes that the faces of a list were read of which a part may be in a box about `middle`. */
static inline void reads_note_box(Reads *reads, size_t list, Vec2 middle, double half_x, double half_y) {
    Box *box = &reads->boxes[list];
    *box = box_include(*box, vec2(middle.x - half_x, middle.y - half_y));
    *box = box_include(*box, vec2(middle.x + half_x, middle.y + half_y));
}

/* True if the segment may have a part in a box; false for one that has none for sure. */
static inline bool reads_may_meet(Box box, Vec2 a, Vec2 b) {
    return !(fmax(a.x, b.x) < box.low.x || fmin(a.x, b.x) > box.high.x || fmax(a.y, b.y) < box.low.y ||
             fmin(a.y, b.y) > box.high.y);
}
