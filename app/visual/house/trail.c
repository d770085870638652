#include "visual/house/trail.h"

#include <stdint.h>

static size_t row_person(const double *row) {
    return (size_t)row[TRACE_PERSON];
}

/* The rows of all trails are one block, owned by the first trail. */
Trail *trail_list(const Observation *observation) {
    const Trace *trace = &observation->trace;
    Trail *trails = memory_zeroed(observation->person_count, sizeof *trails);
    const double **rows = memory_zeroed(trace->rows, sizeof *rows);
    for (size_t i = 0; i < trace->rows; i++)
        trails[row_person(trace_row(trace, i))].count++;
    trails[0].rows = rows;
    size_t start = 0;
    for (size_t p = 0; p < observation->person_count; p++) {
        trails[p].rows = rows + start;
        start += trails[p].count;
        trails[p].count = 0;
    }
    for (size_t i = 0; i < trace->rows; i++) {
        Trail *trail = &trails[row_person(trace_row(trace, i))];
        trail->rows[trail->count++] = trace_row(trace, i);
    }
    return trails;
}

void trail_free_list(Trail *trails) {
    memory_free(trails[0].rows);
    memory_free(trails);
}

/* Rebases the rows after the trace has moved in memory. */
static void rebase_rows(TrailGrowth *growth, const double *values) {
    uintptr_t before = (uintptr_t)growth->values;
    for (size_t p = 0; p < growth->count && growth->values != values; p++)
        for (size_t i = 0; i < growth->trails[p].count; i++)
            growth->trails[p].rows[i] = values + ((uintptr_t)growth->trails[p].rows[i] - before) / sizeof *values;
    growth->values = values;
}

void trail_grow(TrailGrowth *growth, const Observation *observation) {
    const Trace *trace = &observation->trace;
    if (!growth->trails) {
        growth->count = observation->person_count;
        growth->trails = memory_zeroed(growth->count, sizeof *growth->trails);
        growth->capacities = memory_zeroed(growth->count, sizeof *growth->capacities);
    }
    rebase_rows(growth, trace->values);
    for (; growth->rows < trace->rows; growth->rows++) {
        const double *row = trace_row(trace, growth->rows);
        Trail *trail = &growth->trails[row_person(row)];
        trail->rows = memory_reserve(trail->rows, &growth->capacities[row_person(row)], trail->count + 1, sizeof row);
        trail->rows[trail->count++] = row;
    }
}

void trail_clear(TrailGrowth *growth) {
    for (size_t p = 0; p < growth->count; p++)
        memory_free(growth->trails[p].rows);
    memory_free(growth->trails);
    memory_free(growth->capacities);
    *growth = (TrailGrowth){.trails = NULL};
}

double trail_begin(const Trail *trail) {
    return trail->rows[0][TRACE_TIME];
}

double trail_end(const Trail *trail) {
    return trail->rows[trail->count - 1][TRACE_TIME];
}

/* Returns the last row at or before a time, or the first. */
static size_t trail_row(const Trail *trail, double time) {
    size_t low = 0, high = trail->count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (trail->rows[middle][TRACE_TIME] <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

Pose trail_pose(const Trail *trail, double time) {
    size_t i = trail_row(trail, time);
    const double *before = trail->rows[i], *after = trail->rows[i + 1 < trail->count ? i + 1 : i];
    double span = after[TRACE_TIME] - before[TRACE_TIME];
    double part = span > 0 ? fmin(1, fmax(0, (time - before[TRACE_TIME]) / span)) : 0;
    Vec2 from = vec2(before[TRACE_X], before[TRACE_Y]), to = vec2(after[TRACE_X], after[TRACE_Y]);
    double turn = vec2_wrap_angle(after[TRACE_HEADING] - before[TRACE_HEADING]);
    return (Pose){.at = vec2_along(from, part, vec2_sub(to, from)), .heading = before[TRACE_HEADING] + part * turn};
}

const double *trail_row_at(const Trail *trail, double time) {
    return trail->count ? trail->rows[trail_row(trail, time)] : NULL;
}

double trail_compression(const Trail *trail, double from, double to) {
    double most = 0;
    for (size_t i = trail_row(trail, from); i < trail->count && trail->rows[i][TRACE_TIME] <= to; i++)
        most = fmax(most, trail->rows[i][TRACE_RING]);
    return most;
}

const double *trail_hardest(const Trail *trail, double from, double to) {
    const double *hardest = NULL;
    for (size_t i = trail_row(trail, from); i < trail->count && trail->rows[i][TRACE_TIME] <= to; i++)
        if (trail->rows[i][TRACE_TIME] > from &&
            trail->rows[i][TRACE_BODY_FORCE] > (hardest ? hardest[TRACE_BODY_FORCE] : 0))
            hardest = trail->rows[i];
    return hardest;
}
