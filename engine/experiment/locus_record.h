/* A measured locus as observables of a house: where a run passes each place of it, and how fast.
 *
 * The measured locus is resampled every LOCUS_RECORD_STEP of its way. For each place a run has two values: its offset,
 * how far its own locus passes to the left of that place, and its speed there, both loci averaged over one step of
 * their way. A place that the run's locus never comes near to has no values. */
#pragma once

#include "house/house.h"
#include "house/locus.h"
#include "study/experiment.h"

#define LOCUS_RECORD_STEP 0.25 /* m, of way */

typedef struct LocusRecord {
    size_t person;    /* whose locus it is */
    size_t count;     /* places; 0: no locus */
    size_t first;     /* index of the first offset among the observables; the speeds follow the offsets */
    Vec2 *at, *along; /* (count) m; unit, in the direction of travel */
    double *way;      /* (count) m, from the beginning of the locus */
    double *speed;    /* (count) m/s, measured */
} LocusRecord;

/* Resamples a locus, in the arena. A locus shorter than two steps has no places. */
LocusRecord locus_record_of(const Locus *locus, size_t person, size_t first, Arena *arena);

/* Fills in the 2 count observables from `first` on; their names are in the arena. */
void locus_record_describe(const LocusRecord *record, Observable *observables, Arena *arena);

/* Fills in their values (from `first` on) after a run with a trace. */
void locus_record_observe(const LocusRecord *record, const House *house, const Observation *observation,
                          double *observed);
