#include "house/locus.h"

#include "base/memory.h"

Locus locus_of(const House *house, const Observation *observation, size_t person) {
    const Profile *profile = house->people[person].profile;
    const Trace *trace = &observation->trace;
    double ahead = profile->driving == DRIVING_DRIVER ? profile->length / 2 - profile->axle : 0;
    Locus locus = {.points = memory_zeroed(trace->rows, sizeof *locus.points),
                   .times = memory_zeroed(trace->rows, sizeof *locus.times)};
    for (size_t r = 0; r < trace->rows; r++) {
        const double *row = trace_row(trace, r);
        if ((size_t)row[TRACE_PERSON] != person)
            continue;
        locus.points[locus.count] =
            vec2_along(vec2(row[TRACE_X], row[TRACE_Y]), ahead, vec2_heading(row[TRACE_HEADING]));
        locus.times[locus.count++] = row[TRACE_TIME];
    }
    return locus;
}

void locus_free(Locus *locus) {
    memory_free(locus->points);
    memory_free(locus->times);
    *locus = (Locus){0};
}

static double distance_to(const Locus *locus, Vec2 at) {
    double least = HUGE_VAL;
    for (size_t i = 0; i + 1 < locus->count; i++)
        least = fmin(least, vec2_distance(at, vec2_nearest_on_segment(at, locus->points[i], locus->points[i + 1])));
    return least;
}

LocusDistance locus_distance(const Locus *from, const Locus *to) {
    LocusDistance distance = {.counted = 0};
    if (to->count < 2)
        return distance;
    Vec2 begin = to->points[0], end = to->points[to->count - 1];
    Vec2 first_way = vec2_sub(to->points[1], begin), last_way = vec2_sub(end, to->points[to->count - 2]);
    double sum = 0;
    for (size_t i = 0; i < from->count; i++) {
        Vec2 at = from->points[i];
        if (vec2_dot(vec2_sub(at, begin), first_way) < 0 || vec2_dot(vec2_sub(at, end), last_way) > 0)
            continue;
        double apart = distance_to(to, at);
        distance.largest = fmax(distance.largest, apart);
        sum += apart;
        distance.counted++;
    }
    distance.mean = distance.counted ? sum / (double)distance.counted : 0;
    return distance;
}
