/* The largest free disc and the largest free square of a room, by branch and bound.
 *
 * The distance from the nearest obstacle changes by no more than the distance of two places, and the free growth of a
 * square, whose sides keep their directions, by no more than the larger of their two differences along the sides. So a
 * cell holds nothing larger than what its middle has and its half diagonal, or its half side; cells that cannot hold
 * more than what is known are dropped, the others are divided, until what may be missed is below TURNING_RESOLUTION.
 * Squares are tried in the directions of the walls' faces. */
#pragma once

#include "house/house.h"

#define TURNING_RESOLUTION 0.0008 /* m, of a diameter or a side: what may be missed */

typedef struct TurningPlace {
    double size; /* m, the diameter, or the side; 0: none is free */
    Vec2 at;     /* m, its middle */
    Vec2 axis;   /* unit, along a side; (1, 0) of a disc */
} TurningPlace;

/* Both are clipped to 2 FREESPACE_FARTHEST, 3 m. Doors that can be opened are open, and their leaves hang there. */
TurningPlace turning_circle(const House *house, size_t room);
TurningPlace turning_square(const House *house, size_t room);
