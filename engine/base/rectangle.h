/* Rectangles, given by their corners, counter-clockwise. */
#pragma once

#include "base/vec2.h"

/* Fills in the corners of a rectangle about `middle`, size.x long along `axis` (unit) and size.y across. */
void rectangle_corners(Vec2 middle, Vec2 axis, Vec2 size, Vec2 corners[4]);

/* Returns the least shift, m, across a side of either rectangle, that separates the two; negative: they are apart. */
double rectangle_overlap(const Vec2 a[4], const Vec2 b[4]);
