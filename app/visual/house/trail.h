/* One person's rows of a trace. */
#pragma once

#include "house/observation.h"

typedef struct Trail {
    const double **rows; /* (count), in the order of time; see TRACE_COLUMNS */
    size_t count;
} Trail;

/* Returns the trace sorted by person: an array of person_count trails; trail_free_list releases it. */
Trail *trail_list(const Observation *observation);
void trail_free_list(Trail *trails);

/* Does the same for a growing observation: adds new rows. Zero is empty; trail_clear releases it. */
typedef struct TrailGrowth {
    Trail *trails; /* (count) by person */
    size_t *capacities;
    size_t count, rows;
    const double *values; /* of the trace, when rows were last added */
} TrailGrowth;

void trail_grow(TrailGrowth *growth, const Observation *observation);
void trail_clear(TrailGrowth *growth);

/* Returns the pose of the person at a time, interpolated between rows. The trail must have a row. */
Pose trail_pose(const Trail *trail, double time);

/* Returns the row at or before a time, otherwise the first; NULL if the trail is empty. */
const double *trail_row_at(const Trail *trail, double time);

/* Returns the greatest compression of the personal space from one time to another, m. */
double trail_compression(const Trail *trail, double from, double to);

/* Returns the row of the hardest touch after one time and up to another; NULL if there is none. */
const double *trail_hardest(const Trail *trail, double from, double to);

double trail_begin(const Trail *trail);
double trail_end(const Trail *trail);
