#include "draw/mask.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"

#define CELL 4.0 /* design points: a quarter of the smallest text */

void mask_init(Mask *mask, Box box) {
    *mask = (Mask){.box = box};
    mask->nx = (int)fmax(1, ceil(box_width(box) / CELL));
    mask->ny = (int)fmax(1, ceil(box_height(box) / CELL));
    mask->weights = memory_zeroed((size_t)mask->nx * (size_t)mask->ny, sizeof *mask->weights);
}

void mask_clear(Mask *mask) {
    memory_free(mask->weights);
    *mask = (Mask){0};
}

/* Returns the cell that contains a coordinate, clamped to `least` and `most`. */
static int cell_of(double coordinate, double low, int least, int most) {
    double cell = floor((coordinate - low) / CELL);
    return cell < least ? least : cell > most ? most : (int)cell;
}

static void raise(Mask *mask, int x, int y, double weight) {
    float *cell = &mask->weights[(size_t)y * (size_t)mask->nx + (size_t)x];
    if (*cell < (float)weight)
        *cell = (float)weight;
}

static MaskCells cells_of_span(const Mask *mask, int y, double from, double to) {
    return (MaskCells){.left = cell_of(from, mask->box.low.x, 0, mask->nx),
                       .right = cell_of(to, mask->box.low.x, -1, mask->nx - 1),
                       .bottom = y,
                       .top = y};
}

static MaskCells cells_of(const Mask *mask, Box box) {
    MaskCells cells = cells_of_span(mask, 0, box.low.x, box.high.x);
    cells.bottom = cell_of(box.low.y, mask->box.low.y, 0, mask->ny);
    cells.top = cell_of(box.high.y, mask->box.low.y, -1, mask->ny - 1);
    return cells;
}

static void raise_cells(Mask *mask, MaskCells cells, double weight) {
    for (int y = cells.bottom; y <= cells.top; y++)
        for (int x = cells.left; x <= cells.right; x++)
            raise(mask, x, y, weight);
}

void mask_mark_box(Mask *mask, Box box, double weight) {
    raise_cells(mask, cells_of(mask, box), weight);
}

static bool same_cells(MaskCells a, MaskCells b) {
    return a.left == b.left && a.right == b.right && a.bottom == b.bottom && a.top == b.top;
}

void mask_mark_line(Mask *mask, Vec2 from, Vec2 to, double width, double weight) {
    int pieces = (int)ceil(vec2_distance(from, to) / CELL) + 1;
    for (int i = 0; i <= pieces; i++) {
        Vec2 at = vec2_along(from, (double)i / pieces, vec2_sub(to, from));
        MaskCells cells = cells_of(mask, box_around(at, width / 2));
        if (weight == mask->last_weight && same_cells(cells, mask->last))
            continue;
        raise_cells(mask, cells, weight);
        mask->last = cells;
        mask->last_weight = weight;
    }
}

/* Lists where the horizontal line at `y` crosses the rings, in rising order. */
static size_t crossings_at(double y, const Vec2 *points, const size_t *starts, size_t ring_count, double *crossings) {
    size_t count = 0;
    for (size_t r = 0; r < ring_count; r++)
        for (size_t i = starts[r]; i < starts[r + 1]; i++) {
            Vec2 a = points[i], b = points[i + 1 < starts[r + 1] ? i + 1 : starts[r]];
            if ((a.y > y) != (b.y > y))
                crossings[count++] = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
        }
    qsort(crossings, count, sizeof *crossings, order_rising);
    return count;
}

void mask_mark_rings(Mask *mask, const Vec2 *points, const size_t *starts, size_t ring_count, double weight) {
    double *crossings = memory_zeroed(starts[ring_count], sizeof *crossings);
    for (int y = 0; y < mask->ny; y++) {
        double middle = mask->box.low.y + (y + 0.5) * CELL;
        size_t count = crossings_at(middle, points, starts, ring_count, crossings);
        for (size_t i = 0; i + 1 < count; i += 2)
            raise_cells(mask, cells_of_span(mask, y, crossings[i], crossings[i + 1]), weight);
    }
    memory_free(crossings);
}

static double weight_at(const Mask *mask, int x, int y) {
    bool inside = x >= 0 && x < mask->nx && y >= 0 && y < mask->ny;
    return inside ? (double)mask->weights[(size_t)y * (size_t)mask->nx + (size_t)x] : MASK_OUTSIDE;
}

/* Returns the share of cell `i` that lies between two coordinates counted in cells. */
static double overlap(int i, double from, double to) {
    return fmin(to, i + 1) - fmax(from, i);
}

double mask_cost(const Mask *mask, Box box) {
    Vec2 low = vec2_scale(vec2_sub(box.low, mask->box.low), 1 / CELL);
    Vec2 high = vec2_scale(vec2_sub(box.high, mask->box.low), 1 / CELL);
    double sum = 0;
    for (int y = (int)floor(low.y); y < high.y; y++)
        for (int x = (int)floor(low.x); x < high.x; x++)
            sum += weight_at(mask, x, y) * overlap(x, low.x, high.x) * overlap(y, low.y, high.y);
    return sum * CELL * CELL;
}

double mask_line_cost(const Mask *mask, Vec2 from, Vec2 to) {
    double length = vec2_distance(from, to), sum = 0;
    int pieces = (int)ceil(length / CELL) + 1;
    for (int i = 0; i < pieces; i++) {
        Vec2 at = vec2_along(from, (i + 0.5) / pieces, vec2_sub(to, from));
        at = vec2_scale(vec2_sub(at, mask->box.low), 1 / CELL);
        sum += weight_at(mask, (int)floor(at.x), (int)floor(at.y));
    }
    return sum * length / pieces;
}
