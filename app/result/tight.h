/* The tight places of a run in the order in which pictures and the window list them: one for each thing, whichever
 * costs most time first. */
#pragma once

#include "house/observation.h"

enum { TIGHT_MOST = 3 /* places that are listed and marked */ };

typedef struct Tight {
    size_t hazard;     /* its worst dangerous point: index among those of the observation */
    double clearance;  /* m, least of all its points */
    double peak_force; /* N, largest */
    double lost_time;  /* s, of all */
} Tight;

/* Writes the places, the first ones first; returns their number. */
size_t tight_places(const Observation *observation, Tight places[TIGHT_MOST]);
