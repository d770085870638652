#include "route/fast_marching.h"

#include <limits.h>

#include "base/heap.h"
#include "base/memory.h"

/* The fast marching method (Sethian 1996; second order: Sethian 1999). The time T(x), s, after which a front arrives
 * that crosses the ground at 1 / s(x), obeys the eikonal equation
 *
 *     |grad T| = s(x)
 *
 * s the slowness, s/m. On a grid of cell h, m, with upwind differences: of the two neighbours on an axis the one with
 * the smaller time t1, and t2 behind it where that is known and not larger,
 *
 *     a_x (T - q_x)^2 + a_y (T - q_y)^2 = h^2 s^2,    a = 9/4, q = (4 t1 - t2) / 3,    or a = 1, q = t1,
 *
 * an axis counting only where T > q. Times become final in rising order, from a heap; equal ones in the order of the
 * grid, so that the result is always the same. Entries are not moved in the heap when a time falls: stale entries are
 * removed later and find their point final. Points wait in buckets until the front comes near, so that the heap stays
 * small: it holds all entries of the buckets up to the present one. */

#define BUCKET_WIDTH 0.01   /* 1, times the least time from point to point: some tens of entries */
#define MOST_BUCKETS 4096.0 /* within the longest time from point to point: they are wider where that is long */
#define STEEP 2.0f          /* 1, ratio to the slowness behind: more than discomfort causes */

/* The bits of a point's state above its class. */
enum {
    POINT_CLASS = 3,
    POINT_FINAL = 4,
    POINT_GIVEN = 8, /* of a passable point: its time was given as a seed */
    POINT_STEP = 8,  /* of a squeezed point, times the steps from a passable one */
};

static const int neighbours[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

static size_t point_at(const FastMarching *front, int i, int j) {
    return (size_t)j * (size_t)front->nx + (size_t)i;
}

static bool inside_grid(const FastMarching *front, int i, int j) {
    return i >= 0 && j >= 0 && i < front->nx && j < front->ny;
}

void fast_marching_init(FastMarching *front, int nx, int ny, double cell, float *time) {
    size_t points = (size_t)nx * (size_t)ny;
    *front = (FastMarching){.nx = nx, .ny = ny, .cell = cell, .time = time};
    front->slowness = memory_zeroed(points, sizeof *front->slowness);
    front->states = memory_zeroed(points, sizeof *front->states);
    for (size_t p = 0; p < points; p++)
        time[p] = HUGE_VALF;
}

void fast_marching_clear(FastMarching *front) {
    memory_free(front->slowness);
    memory_free(front->states);
    memory_free(front->heap);
    buckets_clear(&front->later);
    *front = (FastMarching){0};
}

static bool entry_before(FastMarchingEntry a, FastMarchingEntry b) {
    return a.time < b.time || (a.time <= b.time && a.point < b.point);
}

HEAP_DEFINE(heap, FastMarchingEntry, entry_before)

/* The smallest final time next to a point on one axis, as q and a of the equation above. */
typedef struct Upwind {
    double time;   /* s, t1; infinite: none */
    double value;  /* s, q */
    double weight; /* 1, a */
} Upwind;

/* True if the second order applies. Between slow and quick ground it would produce wrong times, and at a door it loses
 * some. */
static bool is_even(float here, float behind) {
    return behind <= here && here <= STEEP * behind;
}

static Upwind upwind(const FastMarching *front, size_t point, int place, int end, ptrdiff_t stride, int class) {
    const float *time = front->time + point;
    const unsigned char *states = front->states + point;
    Upwind best = {HUGE_VAL, HUGE_VAL, 1};
    for (int side = -1; side <= 1; side += 2) {
        if (place + side < 0 || place + side >= end)
            continue;
        ptrdiff_t next = side * stride, behind = 2 * next;
        if (!(states[next] & POINT_FINAL) || (states[next] & POINT_CLASS) < class || !((double)time[next] < best.time))
            continue;
        best = (Upwind){(double)time[next], (double)time[next], 1};
        if (place + 2 * side >= 0 && place + 2 * side < end && (states[behind] & POINT_FINAL) &&
            (states[behind] & POINT_CLASS) >= class && time[behind] <= time[next] &&
            is_even(front->slowness[point], front->slowness[point + (size_t)behind])) {
            best.value = (4 * (double)time[next] - (double)time[behind]) / 3;
            best.weight = 2.25;
        }
    }
    return best;
}

/* Returns the larger root of a_x (T - q_x)^2 + a_y (T - q_y)^2 = rise^2, or of one of the terms alone. */
static double solve(const Upwind *x, const Upwind *y, double rise) {
    double one = x->value + rise / sqrt(x->weight), other = y->value + rise / sqrt(y->weight);
    if (one <= y->value || other <= x->value)
        return real_min(one, other);
    double a = x->weight + y->weight, b = x->weight * x->value + y->weight * y->value;
    double apart = x->value - y->value, root = a * rise * rise - x->weight * y->weight * apart * apart;
    return root > 0 ? (b + sqrt(root)) / a : real_min(one, other);
}

static double point_time(const FastMarching *front, int i, int j, int class) {
    size_t point = point_at(front, i, j);
    Upwind x = upwind(front, point, i, front->nx, 1, class), y = upwind(front, point, j, front->ny, front->nx, class);
    double rise = front->cell * (double)front->slowness[point];
    double time = solve(&x, &y, rise);
    /* The second order may give a time before its neighbours where the slowness jumps. */
    return real_max(time, real_min(x.time, y.time));
}

static void put(FastMarching *front, int point, float time) {
    size_t number = front->later.all ? buckets_number(&front->later, time) : 0;
    if (number > front->number && number - front->number <= front->later.last)
        buckets_put(&front->later, point, time);
    else
        heap_put(&front->heap, &front->heap_count, &front->heap_capacity, (FastMarchingEntry){time, point});
}

static void lower_point(FastMarching *front, int i, int j, int class) {
    size_t point = point_at(front, i, j);
    float time = (float)point_time(front, i, j, class);
    if (time < front->time[point]) {
        front->time[point] = time;
        put(front, (int)point, time);
    }
}

/* Removes the first entry of all. */
static FastMarchingEntry take(FastMarching *front) {
    Buckets *later = &front->later;
    while (later->held > 0 && (!front->heap_count || buckets_number(later, front->heap[0].time) > front->number)) {
        BucketEntry entry;
        for (front->number++; buckets_take(later, front->number, &entry);)
            heap_put(&front->heap, &front->heap_count, &front->heap_capacity,
                     (FastMarchingEntry){entry.time, entry.point});
    }
    return heap_take(front->heap, &front->heap_count);
}

/* Makes the times final of all points of a class that are reached from the entries of the heap. */
static void run(FastMarching *front, unsigned char class, int most_steps) {
    while (front->heap_count + front->later.held > 0) {
        FastMarchingEntry entry = take(front);
        size_t point = (size_t)entry.point;
        if (front->states[point] & POINT_FINAL)
            continue;
        front->states[point] |= POINT_FINAL;
        int i = entry.point % front->nx, j = entry.point / front->nx, steps = front->states[point] / POINT_STEP;
        if (steps >= most_steps)
            continue;
        for (int n = 0; n < 4; n++) {
            int x = i + neighbours[n][0], y = j + neighbours[n][1];
            if (!inside_grid(front, x, y))
                continue;
            unsigned char *state = &front->states[point_at(front, x, y)];
            if ((*state & POINT_CLASS) != class || (*state & POINT_FINAL) ||
                (class == FAST_MARCHING_PASSABLE && (*state & POINT_GIVEN)))
                continue;
            if (class == FAST_MARCHING_SQUEEZED && *state < POINT_STEP)
                *state = (unsigned char)(class + POINT_STEP * (steps + 1));
            lower_point(front, x, y, class);
        }
    }
}

/* Makes the buckets for the slowness of the ground, before the first entry is taken. */
static void make_buckets(FastMarching *front) {
    float least = HUGE_VALF, most = 0;
    for (size_t p = 0; p < (size_t)front->nx * (size_t)front->ny; p++)
        if (front->states[p] & POINT_CLASS) {
            least = fminf(least, front->slowness[p]);
            most = fmaxf(most, front->slowness[p]);
        }
    double span = front->cell * (double)most, width = BUCKET_WIDTH * front->cell * (double)least;
    if (span > 0)
        front->later = buckets_make(fmax(width, span / MOST_BUCKETS), span);
}

bool fast_marching_run(FastMarching *front) {
    bool given = front->heap_count > 0;
    make_buckets(front);
    run(front, FAST_MARCHING_PASSABLE, INT_MAX);
    return given;
}

void fast_marching_squeeze(FastMarching *front, int most_steps) {
    for (int j = 0; j < front->ny; j++)
        for (int i = 0; i < front->nx; i++) {
            size_t point = point_at(front, i, j);
            if (front->states[point] != FAST_MARCHING_SQUEEZED)
                continue;
            for (int n = 0; n < 4; n++) {
                int x = i + neighbours[n][0], y = j + neighbours[n][1];
                if (inside_grid(front, x, y) &&
                    (front->states[point_at(front, x, y)] & ~POINT_GIVEN) == (FAST_MARCHING_PASSABLE | POINT_FINAL)) {
                    lower_point(front, i, j, FAST_MARCHING_SQUEEZED);
                    break;
                }
            }
        }
    run(front, FAST_MARCHING_SQUEEZED, most_steps);
}

void fast_marching_seed(FastMarching *front, int i, int j, double time) {
    size_t point = point_at(front, i, j);
    if ((front->states[point] & POINT_CLASS) != FAST_MARCHING_PASSABLE || !((float)time < front->time[point]))
        return;
    front->states[point] |= POINT_GIVEN;
    front->time[point] = (float)time;
    heap_put(&front->heap, &front->heap_count, &front->heap_capacity, (FastMarchingEntry){(float)time, (int)point});
}

/* Returns the slope of the time along one axis, s/m, from the neighbour from which the time came. */
static double slope(const FastMarching *front, size_t point, int place, int end, ptrdiff_t stride, int class) {
    const float *time = front->time + point;
    const unsigned char *states = front->states + point;
    double least = (double)time[0], rise = 0;
    for (int side = -1; side <= 1; side += 2) {
        ptrdiff_t next = side * stride;
        if (place + side < 0 || place + side >= end || !(states[next] & POINT_FINAL) ||
            (states[next] & POINT_CLASS) < class || !((double)time[next] < least))
            continue;
        least = (double)time[next];
        rise = side * ((double)time[0] - least) / front->cell;
    }
    return rise;
}

Vec2 fast_marching_downhill(const FastMarching *front, int i, int j) {
    size_t point = point_at(front, i, j);
    int class = front->states[point] & POINT_CLASS;
    if (!(front->states[point] & POINT_FINAL))
        return vec2(0, 0);
    return vec2_unit(
        vec2(slope(front, point, i, front->nx, 1, class), slope(front, point, j, front->ny, front->nx, class)));
}
