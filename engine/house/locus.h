/* The locus of a person, which is the path of the body's middle, and the distance of two loci. */
#pragma once

#include "house/observation.h"

typedef struct Locus {
    Vec2 *points;  /* (count) m */
    double *times; /* (count) s, in order */
    size_t count;
} Locus;

/* Returns the locus of a person of the house, from the trace. locus_free releases it. */
Locus locus_of(const House *house, const Observation *observation, size_t person);
void locus_free(Locus *locus);

typedef struct LocusDistance {
    double largest, mean; /* m */
    size_t counted;       /* compared points; 0: none */
} LocusDistance;

/* Measures the distance from each point of a locus to the line `to`. Points before the beginning or behind the end of
 * that line are excluded, since the two bodies were not both on that part. */
LocusDistance locus_distance(const Locus *from, const Locus *to);
