/* The smallest rectangle around an outline. */
#pragma once

#include <stddef.h>

#include "base/vec2.h"

typedef struct Rectangle {
    Vec2 centre, size; /* m; the first side is the longer one */
    double angle;      /* degree, direction of the first side, in (-90, 90] */
} Rectangle;

/* Returns the rectangle of `count` points, at least 1; for an outline with very many sides only some directions are
 * tried. */
Rectangle bounding_rectangle_of(const Vec2 *points, size_t count);
