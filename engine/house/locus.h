/* The locus of somebody: the line through the places of the body's middle; and how far apart two loci are. */
#pragma once

#include "house/observation.h"

typedef struct Locus {
    Vec2 *points;  /* (count) m */
    double *times; /* (count) s, in order */
    size_t count;
} Locus;

/* Of a person of the house, from the trace. locus_free releases it. */
Locus locus_of(const House *house, const Observation *observation, size_t person);
void locus_free(Locus *locus);

typedef struct LocusDistance {
    double largest, mean; /* m */
    size_t counted;       /* points; 0: there was nothing to compare */
} LocusDistance;

/* From each point of a locus to the nearest of the line `to`. Points before its beginning and behind its end are left
 * out: there the one body's middle has not been, or the other's no longer is. */
LocusDistance locus_distance(const Locus *from, const Locus *to);
