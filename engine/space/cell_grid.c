#include "space/cell_grid.h"

#include <string.h>

#include "base/memory.h"

enum { LEAST_CELLS = 4096, CELLS_A_PERSON = 8 };

void cell_grid_shape(CellGrid *grid, Box box, double side, size_t people) {
    double width = box_width(box), height = box_height(box);
    double most = (double)LEAST_CELLS + CELLS_A_PERSON * (double)people;
    grid->low = box.low;
    grid->side = fmax(side, fmax(sqrt(width * height / most), fmax(width, height) / most));
    grid->nx = (int)(width / grid->side) + 1;
    grid->ny = (int)(height / grid->side) + 1;
    size_t count = (size_t)grid->nx * (size_t)grid->ny + 1;
    grid->begin = memory_reserve(grid->begin, &grid->cell_capacity, count, sizeof *grid->begin);
    memset(grid->begin, 0, count * sizeof *grid->begin);
    grid->count = 0;
}

static size_t cell_of(const CellGrid *grid, Vec2 at) {
    CellRange range = cell_grid_around(grid, at, 0);
    return (size_t)range.y0 * (size_t)grid->nx + (size_t)range.x0;
}

/* Counting sort: count the people in each cell, find where each cell ends, then place all people from last to first. */
void cell_grid_sort(CellGrid *grid, const size_t *people, size_t count, const Vec2 *centres) {
    size_t cell_count = (size_t)grid->nx * (size_t)grid->ny;
    grid->count = count;
    grid->who = memory_reserve(grid->who, &grid->who_capacity, count, sizeof *grid->who);
    memset(grid->begin, 0, (cell_count + 1) * sizeof *grid->begin);
    for (size_t p = 0; p < count; p++)
        grid->begin[cell_of(grid, centres[people[p]])]++;
    for (size_t c = 1; c <= cell_count; c++)
        grid->begin[c] += grid->begin[c - 1];
    for (size_t p = count; p-- > 0;)
        grid->who[--grid->begin[cell_of(grid, centres[people[p]])]] = (uint32_t)people[p];
}

void cell_grid_copy(CellGrid *to, const CellGrid *from) {
    *to = *from;
    size_t cell_count = (size_t)from->nx * (size_t)from->ny + 1;
    to->begin = memory_zeroed(from->cell_capacity, sizeof *to->begin);
    to->who = memory_zeroed(from->who_capacity, sizeof *to->who);
    if (from->begin)
        memcpy(to->begin, from->begin, cell_count * sizeof *to->begin);
    if (from->count)
        memcpy(to->who, from->who, from->count * sizeof *to->who);
}

void cell_grid_clear(CellGrid *grid) {
    memory_free(grid->begin);
    memory_free(grid->who);
    *grid = (CellGrid){0};
}
