/* The smallest rectangle round an outline. */
#pragma once

#include <stddef.h>

#include "base/vec2.h"

typedef struct Rectangle {
    Vec2 centre, size; /* m; the first side is the longer one */
    double angle;      /* degree, of the first side, from -90 (not itself) to 90 */
} Rectangle;

/* Of (count) points, one or more; of an outline of very many sides only some are tried. */
Rectangle rectangle_around(const Vec2 *points, size_t count);
