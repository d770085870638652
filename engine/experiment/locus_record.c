#include "experiment/locus_record.h"

#include <math.h>

#include "base/text.h"

static const double AHEAD = 1.0;    /* m of way, within which the next place is looked for */
static const double FARTHEST = 1.0; /* m: a locus that passes farther away has no value there */

/* The way to each point of a locus, m (count); memory_free it. */
static double *ways_of(const Locus *locus) {
    double *way = memory_zeroed(locus->count + 1, sizeof *way);
    for (size_t i = 1; i < locus->count; i++)
        way[i] = way[i - 1] + vec2_distance(locus->points[i - 1], locus->points[i]);
    return way;
}

/* A place of a locus. */
typedef struct LocusPlace {
    Vec2 at;
    double time; /* s, when it is left */
} LocusPlace;

/* Returns the place at a way of a locus, within its ends; a stop there belongs to the way before. */
static LocusPlace place_at(const Locus *locus, const double *way, double s) {
    size_t last = locus->count - 1, i = 0;
    if (s >= way[last])
        return (LocusPlace){locus->points[last], locus->times[last]};
    while (i + 1 < last && way[i + 1] <= s)
        i++;
    double share = way[i + 1] > way[i] ? fmax(0, (s - way[i]) / (way[i + 1] - way[i])) : 0;
    return (LocusPlace){vec2_along(locus->points[i], share, vec2_sub(locus->points[i + 1], locus->points[i])),
                        locus->times[i] + share * (locus->times[i + 1] - locus->times[i])};
}

/* Returns the mean speed over one step around a way of a locus; NAN if the locus has no time for it. */
static double speed_at(const Locus *locus, const double *way, double s) {
    double from = fmax(0, s - LOCUS_RECORD_STEP / 2), to = fmin(way[locus->count - 1], s + LOCUS_RECORD_STEP / 2);
    double time = place_at(locus, way, to).time - place_at(locus, way, from).time;
    return time > 0 ? (to - from) / time : (double)NAN;
}

LocusRecord locus_record_of(const Locus *locus, size_t person, size_t first, Arena *arena) {
    LocusRecord record = {.person = person, .first = first};
    if (locus->count < 2)
        return record;
    double *way = ways_of(locus), length = way[locus->count - 1];
    size_t most = (size_t)(length / LOCUS_RECORD_STEP) + 1;
    record.at = arena_allocate(arena, most * sizeof *record.at);
    record.along = arena_allocate(arena, most * sizeof *record.along);
    record.way = arena_allocate(arena, most * sizeof *record.way);
    record.speed = arena_allocate(arena, most * sizeof *record.speed);
    for (size_t k = 1; ((double)k + 0.5) * LOCUS_RECORD_STEP <= length; k++) {
        double s = (double)k * LOCUS_RECORD_STEP, speed = speed_at(locus, way, s);
        Vec2 before = place_at(locus, way, s - LOCUS_RECORD_STEP / 2).at;
        Vec2 along = vec2_sub(place_at(locus, way, s + LOCUS_RECORD_STEP / 2).at, before);
        if (!isfinite(speed) || !(vec2_length(along) > 0))
            continue;
        record.at[record.count] = place_at(locus, way, s).at;
        record.along[record.count] = vec2_unit(along);
        record.way[record.count] = s;
        record.speed[record.count++] = speed;
    }
    memory_free(way);
    return record;
}

void locus_record_describe(const LocusRecord *record, Observable *observables, Arena *arena) {
    for (size_t k = 0; k < record->count; k++) {
        double way = record->way[k];
        observables[record->first + k] = (Observable){
            text_in_arena(arena, "offset_%zu", k + 1), "m",
            text_in_arena(arena, "how far to the left of the measured locus, %.2f m after its start", way)};
        observables[record->first + record->count + k] =
            (Observable){text_in_arena(arena, "speed_%zu", k + 1), "m/s",
                         text_in_arena(arena, "speed beside the measured locus, %.2f m after its start", way)};
    }
}

/* Finds the way of a locus, from `from` on, that is nearest to a place; `offset` is how far to the left of the place it
 * lies. Returns false if it is nowhere near. */
static bool find_beside(const Locus *locus, const double *way, double from, Vec2 at, Vec2 along, double *found,
                        double *offset) {
    double least = FARTHEST;
    for (size_t i = 0; i + 1 < locus->count && way[i] <= from + AHEAD; i++) {
        if (way[i + 1] < from)
            continue;
        Vec2 near = vec2_nearest_on_segment(at, locus->points[i], locus->points[i + 1]);
        double apart = vec2_distance(near, at);
        if (apart >= least)
            continue;
        least = apart;
        *found = way[i] + vec2_distance(locus->points[i], near);
        *offset = vec2_cross(along, vec2_sub(near, at));
    }
    return least < FARTHEST;
}

void locus_record_observe(const LocusRecord *record, const House *house, const Observation *observation,
                          double *observed) {
    Locus locus = locus_of(house, observation, record->person);
    double *way = ways_of(&locus), here = 0, step = record->count ? record->way[0] : 0;
    for (size_t k = 0; k < record->count; k++) {
        double *offset = observed + record->first + k, *speed = offset + record->count;
        *offset = *speed = (double)NAN;
        step = k ? record->way[k] - record->way[k - 1] : step;
        double found = here;
        if (locus.count > 1 && find_beside(&locus, way, here, record->at[k], record->along[k], &found, offset)) {
            *speed = speed_at(&locus, way, found);
            here = found;
        } else {
            here += step;
        }
    }
    memory_free(way);
    locus_free(&locus);
}
