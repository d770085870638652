/* A coarse weight map of a box: labels avoid covering heavy cells. */
#pragma once

#include <stddef.h>

#include "base/vec2.h"

typedef struct MaskCells {
    int left, right, bottom, top; /* none if right < left or top < bottom */
} MaskCells;

typedef struct Mask {
    Box box;
    int nx, ny;
    float *weights;     /* (ny x nx), 1 */
    MaskCells last;     /* those that a line marked last, */
    double last_weight; /* with this weight: the next piece of a locus is often within the same cells */
} Mask;

void mask_init(Mask *mask, Box box);
void mask_clear(Mask *mask);

/* Each raises the weights of the covered cells to at least `weight`. */
void mask_mark_box(Mask *mask, Box box, double weight);
void mask_mark_line(Mask *mask, Vec2 from, Vec2 to, double width, double weight);

/* Marks the inside, even-odd, of rings (starts: ring_count + 1). */
void mask_mark_rings(Mask *mask, const Vec2 *points, const size_t *starts, size_t ring_count, double weight);

/* Returns the sum of weight times area over a box; the part outside the mask counts MASK_OUTSIDE. */
double mask_cost(const Mask *mask, Box box);

/* Returns the sum of weight times length along a line. */
double mask_line_cost(const Mask *mask, Vec2 from, Vec2 to);

#define MASK_OUTSIDE 50.0
