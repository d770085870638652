/* The shape of what a section shows: a closed curve, gone round at a rotation number, or bands that are visited in
 * turn.
 *
 * Rotation number: the mean turn of the section's points about their middle, as a share of a whole turn. Weighted by
 * exp(-1 / (t (1 - t))), which begins and ends smoothly, the mean over a quasi-periodic motion comes near its limit
 * faster than any power of the cycles [Das, Saiki, Sander and Yorke 2017]. A turn and its reverse are one, as a section
 * shows no direction: the number is between 0 and 1/2.
 *
 * Bands: p of them if the states of cycle i, i + p, i + 2 p ... stay apart from all others by more than the largest
 * hole among themselves. */
#pragma once

#include <stddef.h>

#include "cycle/section.h"

typedef struct ShapeRotation {
    double value, error; /* 1; error: difference of the two halves of the record. NAN: the points go round no middle */
} ShapeRotation;

/* Tells the rotation number, in turns per `bands` cycles, of every `bands`-th state, from the tip's deflection and
 * velocity; `omega`, rad/s, makes them comparable. */
ShapeRotation shape_rotation(const Section *section, size_t bands, double omega);

enum { SHAPE_BANDS_MOST = 16, SHAPE_BANDS_CYCLES = 1000 /* last cycles of the section that are looked at */ };

/* Returns the number of bands, 1: none apart. */
size_t shape_bands(const Section *section);
