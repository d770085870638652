/* Everybody who is there, sorted by the cells of a grid: neighbours in space are neighbours in memory.
 *
 * A slot is a place in that order: cell by cell, row by row, within a cell by rising number of the person. A row of
 * cells is thus one run of slots. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/vec2.h"

typedef struct Cells {
    Vec2 low;    /* m, of cell (0, 0) */
    double side; /* m */
    int nx, ny;
    uint32_t *begin; /* (nx * ny + 1) first slot of each cell */
    uint32_t *who;   /* (count) the person in each slot */
    size_t count;
    size_t cell_capacity, who_capacity;
} Cells;

/* Cells of at least `side` m over a box; larger ones where the box would hold far more cells than people. */
void cells_shape(Cells *cells, Box box, double side, size_t people);

/* Sorts `count` people; `centres` is indexed by person. Whoever is outside the box is in the cell nearest to them. */
void cells_sort(Cells *cells, const size_t *people, size_t count, const Vec2 *centres);

/* `to` becomes a copy of `from` with memory of its own. */
void cells_copy(Cells *to, const Cells *from);
void cells_clear(Cells *cells);

/* A rectangle of cells. */
typedef struct CellRange {
    int x0, y0, x1, y1; /* all four inclusive */
} CellRange;

static inline int cells_index(double place, int most) {
    return place > 0 ? place < most ? (int)place : most : 0;
}

static inline CellRange cells_around(const Cells *cells, Vec2 at, double reach) {
    double x = at.x - cells->low.x, y = at.y - cells->low.y, per = 1 / cells->side;
    return (CellRange){cells_index((x - reach) * per, cells->nx - 1), cells_index((y - reach) * per, cells->ny - 1),
                       cells_index((x + reach) * per, cells->nx - 1), cells_index((y + reach) * per, cells->ny - 1)};
}

/* The slots of the cells x0 to x1 in row y. */
static inline uint32_t cells_row(const Cells *cells, const CellRange *range, int y, uint32_t *end) {
    size_t row = (size_t)y * (size_t)cells->nx;
    *end = cells->begin[row + (size_t)range->x1 + 1];
    return cells->begin[row + (size_t)range->x0];
}
