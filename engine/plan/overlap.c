#include "plan/overlap.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"

/* Returns the overlap of two rectangles along the sides of the first, the shorter of both directions; at most 0: they
 * are apart. */
static double overlap(const Vec2 a[4], const Vec2 b[4]) {
    double least = HUGE_VAL;
    for (int side = 0; side < 2; side++) {
        Vec2 axis = vec2_unit(vec2_sub(a[side + 1], a[side]));
        double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
        for (int i = 0; i < 4; i++) {
            double p = vec2_dot(axis, a[i]), q = vec2_dot(axis, b[i]);
            low[0] = fmin(low[0], p);
            high[0] = fmax(high[0], p);
            low[1] = fmin(low[1], q);
            high[1] = fmax(high[1], q);
        }
        least = fmin(least, fmin(high[0] - low[1], high[1] - low[0]));
    }
    return least;
}

/* Returns the depth, m, of the piece in the wall from one place of a segment to another. */
static double depth_in(const Vec2 corners[4], Vec2 from, Vec2 to, double thickness) {
    if (!(vec2_distance(from, to) > 0) || !(thickness > 0))
        return 0;
    Vec2 side = vec2_scale(vec2_left(vec2_unit(vec2_sub(to, from))), thickness / 2);
    Vec2 stretch[4] = {vec2_sub(from, side), vec2_sub(to, side), vec2_add(to, side), vec2_add(from, side)};
    return fmax(0, fmin(overlap(corners, stretch), overlap(stretch, corners)));
}

static int compare_doors(const void *a, const void *b) {
    const Door *p = *(const Door *const *)a, *q = *(const Door *const *)b;
    if (p->at != q->at)
        return p->at < q->at ? -1 : 1;
    return (p > q) - (p < q); /* both are in the plan's list */
}

/* Returns the depth in a segment, whose doors (count), in order, are gaps. */
static double depth_in_segment(const Plan *plan, const Vec2 corners[4], const Wall *wall, size_t segment,
                               const Door *const *doors, size_t count) {
    Vec2 from = wall->points.at[segment];
    double deepest = 0;
    for (size_t d = 0; d < count; d++) {
        Vec2 begin, end;
        plan_geometry_door_ends(plan, doors[d], &begin, &end);
        deepest = fmax(deepest, depth_in(corners, from, begin, wall->thickness));
        from = end;
    }
    return fmax(deepest, depth_in(corners, from, wall->points.at[segment + 1], wall->thickness));
}

/* True if a piece with these corners may be in the segment. */
static bool is_near(const Vec2 corners[4], Vec2 from, Vec2 to, double thickness) {
    Box piece = box_empty(), segment = box_expand(box_include(box_around(from, 0), to), thickness / 2);
    for (int i = 0; i < 4; i++)
        piece = box_include(piece, corners[i]);
    return piece.low.x < segment.high.x && segment.low.x < piece.high.x && piece.low.y < segment.high.y &&
           segment.low.y < piece.high.y;
}

double overlap_depth(const Plan *plan, const Furniture *piece, size_t *wall) {
    Vec2 corners[4];
    plan_geometry_corners(piece, corners);
    const Door **doors = memory_zeroed(plan->door_count + 1, sizeof *doors);
    double deepest = 0;
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t s = 0; s + 1 < plan->walls[w].points.count; s++) {
            const Vec2 *ends = plan->walls[w].points.at + s;
            size_t count = 0;
            if (!is_near(corners, ends[0], ends[1], plan->walls[w].thickness))
                continue;
            for (size_t d = 0; d < plan->door_count; d++)
                if (plan->doors[d].wall_index == w && plan->doors[d].segment == (int)s)
                    doors[count++] = &plan->doors[d];
            if (count > 1)
                qsort(doors, count, sizeof *doors, compare_doors);
            double depth = depth_in_segment(plan, corners, &plan->walls[w], s, doors, count);
            if (depth <= deepest)
                continue;
            deepest = depth;
            *wall = w;
        }
    memory_free(doors);
    return deepest;
}
