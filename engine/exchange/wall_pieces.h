/* Finds the straight pieces of walls that a drawing shows as two parallel lines, one for each face.
 *
 * Two lines are the faces of a piece where they run beside each other, 4 cm to 60 cm apart. A stretch of a line is the
 * face of one piece only. Lines that continue each other are one face. Where several pairs compete, these rules decide:
 *
 * 1. Lines between two faces, each less than 25 cm from the next, are layers of one wall (cavity, insulation, axis).
 * 2. Two lines of which each has a nearer partner on its other side are the sides of a shaft, and go last.
 * 3. The distance that most of the drawing's lines keep goes first.
 *
 * A piece much shorter than thick needs another piece that confirms it. Private to the importers. */
#pragma once

#include "exchange/wall_chains.h"

typedef struct WallPiece {
    Vec2 a, b; /* m, ends of the centre line */
    double thickness;
    int faces[2]; /* indices of the lines */
} WallPiece;

typedef struct WallPieces {
    WallPiece *list; /* (count); memory_free it */
    size_t count, capacity;
    double share;   /* 1: length of the lines that became faces, of all lines */
    size_t doubled; /* lines that repeat an earlier one */
    bool too_many;  /* the drawing has so many lines that no pieces were looked for */
} WallPieces;

/* Finds the pieces among lines whose coordinates are multiplied by `scale` to give metres; lines with a thickness are
 * ignored. Finds none in a drawing with too many lines: the number of comparisons is bounded. */
WallPieces wall_pieces_find(const WallLines *lines, double scale);
