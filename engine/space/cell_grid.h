/* The people present, sorted by the cells of a grid, so that neighbours in space are neighbours in memory.
 *
 * A slot is a position in that order: cell by cell, row by row, and by rising person index within a cell. A row of
 * cells is therefore one run of slots. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/vec2.h"

typedef struct CellGrid {
    Vec2 low;    /* m, of cell (0, 0) */
    double side; /* m */
    int nx, ny;
    uint32_t *begin; /* (nx * ny + 1) first slot of each cell */
    uint32_t *who;   /* (count) the person in each slot */
    size_t count;
    size_t cell_capacity, who_capacity;
} CellGrid;

/* Lays cells of at least `side` m over a box; they are larger where the box would have far more cells than people. */
void cell_grid_shape(CellGrid *grid, Box box, double side, size_t people);

/* Sorts `count` people; `centres` is indexed by person. A person outside the box belongs to the nearest cell. */
void cell_grid_sort(CellGrid *grid, const size_t *people, size_t count, const Vec2 *centres);

/* Makes `to` a copy of `from` with memory of its own. */
void cell_grid_copy(CellGrid *to, const CellGrid *from);
void cell_grid_clear(CellGrid *grid);

/* A rectangle of cells. */
typedef struct CellRange {
    int x0, y0, x1, y1; /* all four inclusive */
} CellRange;

static inline int cell_grid_index(double place, int most) {
    return place > 0 ? place < most ? (int)place : most : 0;
}

static inline CellRange cell_grid_around(const CellGrid *grid, Vec2 at, double reach) {
    double x = at.x - grid->low.x, y = at.y - grid->low.y, per = 1 / grid->side;
    return (CellRange){
        cell_grid_index((x - reach) * per, grid->nx - 1), cell_grid_index((y - reach) * per, grid->ny - 1),
        cell_grid_index((x + reach) * per, grid->nx - 1), cell_grid_index((y + reach) * per, grid->ny - 1)};
}

/* Returns the first slot of the cells x0 to x1 in row y; `*end` is the slot after the last. */
static inline uint32_t cell_grid_row(const CellGrid *grid, const CellRange *range, int y, uint32_t *end) {
    size_t row = (size_t)y * (size_t)grid->nx;
    *end = grid->begin[row + (size_t)range->x1 + 1];
    return grid->begin[row + (size_t)range->x0];
}
