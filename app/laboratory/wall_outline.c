#include "laboratory/wall_outline.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"

/* A stretch of the wall's centre line, m from its start. */
typedef struct Stretch {
    double from, to;
} Stretch;

/* Returns the vector from the corner of a wall's centre line to the corner of its face. */
static Vec2 mitre(Vec2 before, Vec2 at, Vec2 after, double half) {
    Vec2 in = vec2_left(vec2_unit(vec2_sub(at, before))), out = vec2_left(vec2_unit(vec2_sub(after, at)));
    Vec2 sum = vec2_add(in, out);
    double square = vec2_dot(sum, sum);
    return square < 0.1 ? vec2_scale(out, half) : vec2_scale(sum, 2 * half / square);
}

/* Writes a path along one face and back along the other. */
static size_t write_path(const Vec2 *at, size_t count, double half, Vec2 *points) {
    bool closed = vec2_distance(at[0], at[count - 1]) == 0;
    for (size_t i = 0; i < count; i++) {
        Vec2 before = i ? at[i - 1] : closed ? at[count - 2] : vec2_sub(vec2_scale(at[0], 2), at[1]);
        Vec2 after = i + 1 < count ? at[i + 1] : closed ? at[1] : vec2_sub(vec2_scale(at[i], 2), at[i - 1]);
        Vec2 aside = mitre(before, at[i], after, half);
        points[i] = vec2_sub(at[i], aside);
        points[2 * count - 1 - i] = vec2_add(at[i], aside);
    }
    return 2 * count;
}

/* Returns the distance of a corner from the wall's start, m along it. */
static double length_to(const Wall *wall, size_t corner) {
    double length = 0;
    for (size_t i = 1; i <= corner; i++)
        length += vec2_distance(wall->points.at[i - 1], wall->points.at[i]);
    return length;
}

static int compare_stretches(const void *a, const void *b) {
    double p = ((const Stretch *)a)->from, q = ((const Stretch *)b)->from;
    return (p > q) - (p < q);
}

/* Lists the wall's doors in their order, those that overlap as one. */
static size_t list_gaps(const Plan *plan, size_t wall, Stretch *gaps) {
    size_t count = 0, merged = 0;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        if (door->wall_index != wall)
            continue;
        double middle = length_to(&plan->walls[wall], (size_t)door->segment) + door->at;
        gaps[count++] = (Stretch){middle - door->width / 2, middle + door->width / 2};
    }
    qsort(gaps, count, sizeof *gaps, compare_stretches);
    for (size_t g = 0; g < count; g++)
        if (merged && gaps[g].from <= gaps[merged - 1].to)
            gaps[merged - 1].to = fmax(gaps[merged - 1].to, gaps[g].to);
        else
            gaps[merged++] = gaps[g];
    return merged;
}

/* Lists the points of a stretch of the centre line, which may go on behind the end of a closed wall. */
static size_t list_path(const Wall *wall, Stretch stretch, Vec2 *path) {
    size_t sides = wall->points.count - 1, count = 0;
    double begin = 0;
    for (size_t i = 0; i < 2 * sides && begin < stretch.to; i++) {
        Vec2 a = wall->points.at[i % sides], b = wall->points.at[i % sides + 1];
        double length = vec2_distance(a, b), end = begin + length;
        if (end > stretch.from && count == 0)
            path[count++] = vec2_along(a, (stretch.from - begin) / length, vec2_sub(b, a));
        if (count)
            path[count++] = stretch.to < end ? vec2_along(a, (stretch.to - begin) / length, vec2_sub(b, a)) : b;
        begin = end;
    }
    return count;
}

size_t wall_outline_write(const Plan *plan, size_t wall, double least, Vec2 *points, size_t most) {
    const Wall *shown = &plan->walls[wall];
    size_t corners = shown->points.count, count = 0, room = 2 * corners + 2;
    const Vec2 *at = shown->points.at;
    double half = fmax(shown->thickness, least) / 2, length = length_to(shown, corners - 1);
    Stretch *gaps = memory_zeroed(plan->door_count + 1, sizeof *gaps);
    Vec2 *path = memory_zeroed(room, sizeof *path);
    size_t gap_count = list_gaps(plan, wall, gaps);
    bool closed = vec2_distance(at[0], at[corners - 1]) == 0, fits = gap_count > 0;
    for (size_t piece = 0; piece <= gap_count && fits; piece++) {
        bool last = piece == gap_count;
        Stretch stretch = {piece ? gaps[piece - 1].to : 0, last ? length : gaps[piece].from};
        if (closed && !piece)
            continue; /* it goes on from the last one */
        if (closed && last)
            stretch.to += gaps[0].from;
        size_t points_of = stretch.to > stretch.from ? list_path(shown, stretch, path) : 0;
        fits = count + 2 * points_of + 1 <= most;
        if (fits && points_of && count)
            points[count++] = vec2(NAN, NAN);
        if (fits && points_of)
            count += write_path(path, points_of, half, points + count);
    }
    if (!fits)
        count = write_path(at, corners < most / 2 ? corners : most / 2, half, points);
    memory_free(path);
    memory_free(gaps);
    return count;
}
