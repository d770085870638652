#include "route/neck.h"

#include "base/heap.h"
#include "base/memory.h"
#include "base/real.h"
#include "space/passage.h"

/* The widest way (maximin; Pollack 1960) of a point over the grid of distances d. A step of length h between two grid
 * points p and q meets no obstacle if d(p) + d(q) > h, since the two discs of free space then cover the step; its width
 * is the least of 2 d(p) and 2 d(q). Where the way is narrowest, it is searched again on a grid of WINDOW_CELL with
 * exact distances. At a neck the nearest obstacles lie opposite each other, so that the width is the distance between
 * their two faces. */

#define WINDOW_CELL 0.0025 /* m */
#define WINDOW_REACH 3.0   /* 1, cells of the coarse grid on either side of the neck */
#define SAME_WIDTH 0.005   /* m: the distance between two faces is the width if it differs by no more */

typedef struct Opening {
    float width; /* m, least width on the way to the point */
    int point;
} Opening;

static bool before(Opening a, Opening b) {
    return a.width > b.width || (a.width >= b.width && a.point < b.point);
}

HEAP_DEFINE(openings, Opening, before)

/* A grid of distances, and the widest ways on it. */
typedef struct Ways {
    Vec2 origin; /* m */
    double cell; /* m */
    int nx, ny;
    const float *distance; /* (ny x nx) m */
    int *parent;           /* (ny x nx) -1: the start, -2: not entered, otherwise the point before */
    Opening *heap;
    size_t heap_count, heap_capacity;
} Ways;

static Vec2 place(const Ways *ways, int point) {
    return vec2(ways->origin.x + point % ways->nx * ways->cell, ways->origin.y + point / ways->nx * ways->cell);
}

/* Returns the grid point that is nearest to a place, or -1. */
static int nearest_point(const Ways *ways, Vec2 at) {
    double x = floor((at.x - ways->origin.x) / ways->cell + 0.5), y = floor((at.y - ways->origin.y) / ways->cell + 0.5);
    return x >= 0 && y >= 0 && x < ways->nx && y < ways->ny ? (int)y * ways->nx + (int)x : -1;
}

static void ways_begin(Ways *ways, int start) {
    size_t points = (size_t)ways->nx * (size_t)ways->ny;
    ways->parent = memory_zeroed(points, sizeof *ways->parent);
    for (size_t i = 0; i < points; i++)
        ways->parent[i] = -2;
    ways->parent[start] = -1;
    openings_put(&ways->heap, &ways->heap_count, &ways->heap_capacity, (Opening){2 * ways->distance[start], start});
}

static void ways_clear(Ways *ways) {
    memory_free(ways->parent);
    memory_free(ways->heap);
    ways->parent = NULL;
    ways->heap = NULL;
    ways->heap_count = ways->heap_capacity = 0;
}

/* Returns the neighbour of a point on one of its four sides if the step to it meets no obstacle, otherwise -1. */
static int ways_step(const Ways *ways, int point, int side) {
    static const int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    int x = point % ways->nx + steps[side][0], y = point / ways->nx + steps[side][1];
    if (x < 0 || y < 0 || x >= ways->nx || y >= ways->ny)
        return -1;
    int next = y * ways->nx + x;
    float from = ways->distance[point], to = ways->distance[next];
    return from > 0 && to > 0 && (double)(from + to) > ways->cell ? next : -1;
}

/* Returns the width of a way that goes on to a point, m. */
static float width_on(const Ways *ways, Opening here, int next) {
    return 2 * ways->distance[next] < here.width ? 2 * ways->distance[next] : here.width;
}

/* Takes the next point of the search and enters its neighbours; false at the end. */
static bool ways_advance(Ways *ways, Opening *here) {
    if (ways->heap_count == 0)
        return false;
    *here = openings_take(ways->heap, &ways->heap_count);
    for (int s = 0; s < 4; s++) {
        int next = ways_step(ways, here->point, s);
        if (next < 0 || ways->parent[next] != -2)
            continue;
        ways->parent[next] = here->point; /* the first arrival is the widest, as widths only fall along a way */
        openings_put(&ways->heap, &ways->heap_count, &ways->heap_capacity,
                     (Opening){width_on(ways, *here, next), next});
    }
    return true;
}

/* A way, from its end back to its start. */
typedef struct Chain {
    int *points; /* (count) */
    size_t count, capacity;
} Chain;

static void chain_add(Chain *chain, int point) {
    chain->points = memory_reserve(chain->points, &chain->capacity, chain->count + 1, sizeof *chain->points);
    chain->points[chain->count++] = point;
}

/* Returns the way to a point, and from there to `end`, which is one of its neighbours or the point itself. */
static Chain chain_to(const Ways *ways, int end, int point) {
    Chain chain = {0};
    if (end != point)
        chain_add(&chain, end);
    for (; point >= 0; point = ways->parent[point])
        chain_add(&chain, point);
    return chain;
}

/* Returns the index of the narrowest point of a way. */
static size_t narrowest_on_way(const Ways *ways, const Chain *chain) {
    size_t narrowest = 0;
    for (size_t i = 0; i < chain->count; i++)
        if (ways->distance[chain->points[i]] <= ways->distance[chain->points[narrowest]])
            narrowest = i;
    return narrowest;
}

/* Moves from a point of the way towards its start, `step` 1, or its end, -1, until the window ends there. */
static Vec2 leave_window(const Ways *ways, const Chain *chain, size_t from, int step, double reach) {
    Vec2 middle = place(ways, chain->points[from]), at = middle;
    for (size_t i = from + (size_t)step; i < chain->count; i += (size_t)step) {
        Vec2 there = place(ways, chain->points[i]);
        if (fabs(there.x - middle.x) > reach || fabs(there.y - middle.y) > reach)
            break;
        at = there;
    }
    return at;
}

/* Returns the point with the largest distance in the disc of free space about a place, at most one coarse cell away:
 * the coarse way may pass beside the middle of a passage. -1 outside the window. */
static int roomiest_point(const Ways *ways, Vec2 about, double cell) {
    int best = nearest_point(ways, about);
    if (best < 0)
        return -1;
    int reach = (int)(real_min(cell, (double)ways->distance[best]) / ways->cell);
    int x = best % ways->nx, y = best / ways->nx;
    for (int j = y - reach; j <= y + reach; j++)
        for (int i = x - reach; i <= x + reach; i++) {
            bool within = (i - x) * (i - x) + (j - y) * (j - y) <= reach * reach;
            if (within && i >= 0 && j >= 0 && i < ways->nx && j < ways->ny &&
                ways->distance[j * ways->nx + i] > ways->distance[best])
                best = j * ways->nx + i;
        }
    return best;
}

/* Searches the narrowest place on a fine grid about it, between two places of the way. */
static void refine(Neck *neck, const FreeSpace *space, Vec2 from, Vec2 to, double reach) {
    int side = 2 * (int)ceil(reach / WINDOW_CELL) + 1;
    float *distance = memory_zeroed((size_t)side * (size_t)side, sizeof *distance);
    Ways ways = {.origin = vec2_sub(neck->at, vec2(side / 2 * WINDOW_CELL, side / 2 * WINDOW_CELL)),
                 .cell = WINDOW_CELL,
                 .nx = side,
                 .ny = side,
                 .distance = distance};
    for (int point = 0; point < side * side; point++) {
        Vec2 at = place(&ways, point);
        bool inside = freespace_distance(space, at) < -space->cell;
        distance[point] = inside ? -1 : (float)freespace_exact(space, at, FREESPACE_FARTHEST, NULL);
    }
    int start = roomiest_point(&ways, from, space->cell), end = roomiest_point(&ways, to, space->cell);
    if (start >= 0 && end >= 0) {
        Opening here = {0, -1};
        ways_begin(&ways, start);
        while (here.point != end && ways_advance(&ways, &here)) {
        }
        if (here.point == end) {
            Chain way = chain_to(&ways, end, end);
            int narrowest = way.points[narrowest_on_way(&ways, &way)];
            *neck = (Neck){place(&ways, narrowest), 2 * (double)distance[narrowest]};
            memory_free(way.points);
        }
        ways_clear(&ways);
    }
    memory_free(distance);
}

/* Replaces the width by the distance between the two faces that face each other there. */
static void measure(Neck *neck, const FreeSpace *space) {
    const Outline *outline = space->outline;
    int near, opposite;
    freespace_exact(space, neck->at, FREESPACE_FARTHEST, &near);
    if (near < 0)
        return;
    Vec2 foot = vec2_nearest_on_segment(neck->at, outline->faces[near].a, outline->faces[near].b);
    outline_ray(outline, neck->at, vec2_unit(vec2_sub(neck->at, foot)), FREESPACE_FARTHEST, &opposite);
    if (opposite < 0)
        return;
    Vec2 middle = neck->at;
    double width = passage_between(&outline->faces[near], &outline->faces[opposite], &middle);
    if (fabs(width - neck->width) <= SAME_WIDTH)
        *neck = (Neck){middle, width};
}

/* Searches the widest way from `from`, beside the grid point `start`, to a goal. A way that goes round an exit's line
 * may reach the points behind it before one that crosses it, so that all steps from a point are looked at, also those
 * to points that have been reached. */
static NeckAnswer widest_way(Chain *way, Ways *ways, int start, Vec2 from, const RouteQuery *query, const Goal *goal) {
    size_t exit;
    Opening here, end = {0, -1};
    int last = -1; /* the point before the end */
    ways_begin(ways, start);
    if (field_goal_reached(goal, query->plan, from, place(ways, start), &exit))
        end = (Opening){2 * ways->distance[start], last = start};
    while (ways_advance(ways, &here) && here.width > end.width) {
        if (stop_requested(query->stop))
            return NECK_INTERRUPTED;
        Vec2 before = here.point == start ? from : place(ways, here.point);
        for (int s = 0; s < 4; s++) {
            int next = ways_step(ways, here.point, s);
            if (next < 0 || width_on(ways, here, next) <= end.width ||
                !field_goal_reached(goal, query->plan, before, place(ways, next), &exit))
                continue;
            end = (Opening){width_on(ways, here, next), next};
            last = here.point;
        }
    }
    if (end.point < 0)
        return NECK_NONE;
    *way = chain_to(ways, end.point, last);
    return NECK_FOUND;
}

/* Finds the neck of one leg, and moves `*at` to the leg's end. */
static NeckAnswer leg_neck(Neck *neck, const RouteQuery *query, const Goal *goal, Vec2 *at) {
    const FreeSpace *space = query->space;
    Ways ways = {
        .origin = space->origin, .cell = space->cell, .nx = space->nx, .ny = space->ny, .distance = space->distance};
    int start = nearest_point(&ways, *at);
    if (start < 0)
        return NECK_NONE;
    Chain way = {0};
    NeckAnswer answer = widest_way(&way, &ways, start, *at, query, goal);
    if (answer == NECK_FOUND) {
        size_t narrowest = narrowest_on_way(&ways, &way);
        double reach = WINDOW_REACH * space->cell;
        *neck = (Neck){place(&ways, way.points[narrowest]), 2 * (double)space->distance[way.points[narrowest]]};
        *at = place(&ways, way.points[0]);
        refine(neck, space, leave_window(&ways, &way, narrowest, 1, reach),
               leave_window(&ways, &way, narrowest, -1, reach), reach);
        measure(neck, space);
        memory_free(way.points);
    }
    ways_clear(&ways);
    return answer;
}

NeckAnswer neck_find(Neck *neck, const RouteQuery *query, const Goal *goals, size_t goal_count) {
    Vec2 at = query->at;
    *neck = (Neck){at, HUGE_VAL};
    for (size_t g = 0; g < goal_count; g++) {
        Neck leg;
        NeckAnswer answer = leg_neck(&leg, query, &goals[g], &at);
        if (answer != NECK_FOUND)
            return answer;
        if (leg.width < neck->width)
            *neck = leg;
    }
    return NECK_FOUND;
}
