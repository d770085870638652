/* Rectangles by their corners, counter-clockwise. */
#pragma once

#include "base/vec2.h"

/* Of one about `middle`, size.x long along `axis` (unit) and size.y across. */
void rectangle_corners(Vec2 middle, Vec2 axis, Vec2 size, Vec2 corners[4]);

/* By how much, m, one must be shifted, across a side of either, to be free of the other; negative: they are apart. */
double rectangle_overlap(const Vec2 a[4], const Vec2 b[4]);
