#include "space/cells.h"

#include <string.h>

#include "base/memory.h"

enum { LEAST_CELLS = 4096, CELLS_A_PERSON = 8 };

void cells_shape(Cells *cells, Box box, double side, size_t people) {
    double width = box_width(box), height = box_height(box);
    double most = (double)LEAST_CELLS + CELLS_A_PERSON * (double)people;
    cells->low = box.low;
    cells->side = fmax(side, fmax(sqrt(width * height / most), fmax(width, height) / most));
    cells->nx = (int)(width / cells->side) + 1;
    cells->ny = (int)(height / cells->side) + 1;
    size_t count = (size_t)cells->nx * (size_t)cells->ny + 1;
    cells->begin = memory_reserve(cells->begin, &cells->cell_capacity, count, sizeof *cells->begin);
    memset(cells->begin, 0, count * sizeof *cells->begin);
    cells->count = 0;
}

static size_t cell_of(const Cells *cells, Vec2 at) {
    CellRange range = cells_around(cells, at, 0);
    return (size_t)range.y0 * (size_t)cells->nx + (size_t)range.x0;
}

/* Counting sort: how many in each cell, where each cell ends, then everybody into place from the last to the first. */
void cells_sort(Cells *cells, const size_t *people, size_t count, const Vec2 *centres) {
    size_t cell_count = (size_t)cells->nx * (size_t)cells->ny;
    cells->count = count;
    cells->who = memory_reserve(cells->who, &cells->who_capacity, count, sizeof *cells->who);
    memset(cells->begin, 0, (cell_count + 1) * sizeof *cells->begin);
    for (size_t p = 0; p < count; p++)
        cells->begin[cell_of(cells, centres[people[p]])]++;
    for (size_t c = 1; c <= cell_count; c++)
        cells->begin[c] += cells->begin[c - 1];
    for (size_t p = count; p-- > 0;)
        cells->who[--cells->begin[cell_of(cells, centres[people[p]])]] = (uint32_t)people[p];
}

void cells_copy(Cells *to, const Cells *from) {
    *to = *from;
    size_t cell_count = (size_t)from->nx * (size_t)from->ny + 1;
    to->begin = memory_zeroed(from->cell_capacity, sizeof *to->begin);
    to->who = memory_zeroed(from->who_capacity, sizeof *to->who);
    if (from->begin)
        memcpy(to->begin, from->begin, cell_count * sizeof *to->begin);
    if (from->count)
        memcpy(to->who, from->who, from->count * sizeof *to->who);
}

void cells_clear(Cells *cells) {
    memory_free(cells->begin);
    memory_free(cells->who);
    *cells = (Cells){0};
}
