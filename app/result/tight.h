/* The tight places of a run in the order in which pictures, tables and the window list them: one for each thing,
 * whichever costs most time first. In a crowd they are the places of its jams, see jam.h. */
#pragma once

#include "base/memory.h"
#include "house/observation.h"

enum { TIGHT_MOST = 3 /* places that are listed and marked */ };

typedef struct Tight {
    size_t hazard;     /* its worst dangerous point: index among those of the observation */
    double clearance;  /* m, least of all its points */
    double peak_force; /* N, largest */
    double lost_time;  /* s, of all */
} Tight;

/* Writes the places that are listed, the first ones first; returns their number. */
size_t tight_places(const House *house, const Observation *observation, Tight places[TIGHT_MOST]);

/* Writes all places in the same order; returns their number. */
size_t tight_all(const House *house, const Observation *observation, Tight places[HAZARDS_MOST]);

/* Returns the number of all places, also of those that are not listed. */
size_t tight_count(const House *house, const Observation *observation);

/* Returns that number without the first `listed` ones as people read it: "2", or "at least 2" if a run has more
 * dangerous points than are kept. */
const char *tight_number(const House *house, const Observation *observation, size_t listed, Arena *arena);

/* Returns a clearance as people read it: "4.4 cm", "touches", or NULL if nothing came near. */
const char *tight_to_spare(double clearance, Arena *arena);
