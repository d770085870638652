#include "exchange/wall_chains.h"

#include <math.h>
#include <stdint.h>

#include "base/real.h"

static const double ARC_DEVIATION = 0.01; /* m: largest deviation of straight lines from an arc */
static const double STRAIGHT = 1e-6;      /* 1: sine of the largest turn between lines that count as straight */

/* Ends ------------------------------------------------------------------------------------------------------------ */

/* Points where lines end, found by a hash of their grid square. The end of a line is 2 * line + (0 or 1). */
typedef struct Ends {
    const WallLine *lines;
    size_t count;
    Vec2 *places;   /* (place_count) */
    size_t *next;   /* (place_count) previous place in the same bucket, or SIZE_MAX */
    size_t *bucket; /* (bucket_count, a power of two) */
    size_t place_count, bucket_count;
    size_t *place_of; /* (2 * count) place of an end */
    size_t *first;    /* (place_count) first end at the place; after[end] is the next one, SIZE_MAX at the last */
    size_t *after;    /* (2 * count) */
    bool *used;       /* (count) */
} Ends;

static size_t bucket_of(const Ends *ends, int64_t x, int64_t y) {
    uint64_t hash = (uint64_t)x * 0x9e3779b97f4a7c15u ^ (uint64_t)y * 0xc2b2ae3d27d4eb4fu;
    return (hash ^ hash >> 29) & (ends->bucket_count - 1);
}

static int64_t square(double coordinate) {
    return (int64_t)floor(coordinate / WALL_CHAINS_TOLERANCE);
}

/* Returns the place of a point, adding one if none is near: places are at least the tolerance apart, so that few
 * share a square. */
static size_t find_place(Ends *ends, Vec2 at) {
    int64_t x = square(at.x), y = square(at.y);
    for (int64_t i = x - 1; i <= x + 1; i++)
        for (int64_t j = y - 1; j <= y + 1; j++)
            for (size_t p = ends->bucket[bucket_of(ends, i, j)]; p != SIZE_MAX; p = ends->next[p])
                if (vec2_distance(ends->places[p], at) < WALL_CHAINS_TOLERANCE)
                    return p;
    size_t bucket = bucket_of(ends, x, y), place = ends->place_count++;
    ends->places[place] = at;
    ends->next[place] = ends->bucket[bucket];
    ends->bucket[bucket] = place;
    ends->first[place] = SIZE_MAX;
    return place;
}

static bool same_line(const Ends *ends, size_t one, size_t other) {
    const size_t *a = ends->place_of + 2 * one, *b = ends->place_of + 2 * other;
    return (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[0]);
}

/* True for a line of zero length or a duplicate, which then counts as used. */
static bool is_spare(const Ends *ends, size_t line) {
    size_t from = ends->place_of[2 * line];
    if (from == ends->place_of[2 * line + 1])
        return true;
    size_t looked_at = 0;
    for (size_t end = ends->first[from]; end != SIZE_MAX && looked_at < 64; end = ends->after[end], looked_at++)
        if (same_line(ends, end / 2, line))
            return true;
    return false;
}

static Ends ends_find(const WallLine *lines, size_t count) {
    Ends ends = {.lines = lines, .count = count, .bucket_count = 16};
    while (ends.bucket_count < 4 * count)
        ends.bucket_count *= 2;
    ends.places = memory_zeroed(2 * count, sizeof *ends.places);
    ends.next = memory_zeroed(2 * count, sizeof *ends.next);
    ends.first = memory_zeroed(2 * count, sizeof *ends.first);
    ends.place_of = memory_zeroed(2 * count, sizeof *ends.place_of);
    ends.after = memory_zeroed(2 * count, sizeof *ends.after);
    ends.used = memory_zeroed(count, sizeof *ends.used);
    ends.bucket = memory_zeroed(ends.bucket_count, sizeof *ends.bucket);
    for (size_t b = 0; b < ends.bucket_count; b++)
        ends.bucket[b] = SIZE_MAX;
    for (size_t l = 0; l < count; l++) {
        ends.place_of[2 * l] = find_place(&ends, lines[l].a);
        ends.place_of[2 * l + 1] = find_place(&ends, lines[l].b);
        ends.used[l] = is_spare(&ends, l);
        for (size_t end = 2 * l; end < 2 * l + 2 && !ends.used[l]; end++) {
            ends.after[end] = ends.first[ends.place_of[end]];
            ends.first[ends.place_of[end]] = end;
        }
    }
    return ends;
}

static void ends_free(Ends *ends) {
    memory_free(ends->places);
    memory_free(ends->next);
    memory_free(ends->first);
    memory_free(ends->place_of);
    memory_free(ends->after);
    memory_free(ends->used);
    memory_free(ends->bucket);
}

/* Chains ---------------------------------------------------------------------------------------------------------- */

/* Returns the end of the only other line that meets the line of `end` there and has its thickness and height, or
 * SIZE_MAX. */
static size_t meets(const Ends *ends, size_t end) {
    size_t a = ends->first[ends->place_of[end]], b = ends->after[a];
    if (b == SIZE_MAX || ends->after[b] != SIZE_MAX)
        return SIZE_MAX;
    size_t other = a == end ? b : a;
    const WallLine *one = &ends->lines[end / 2], *two = &ends->lines[other / 2];
    return one->thickness == two->thickness && one->height == two->height ? other : SIZE_MAX;
}

/* Same, among lines that are not yet in a chain. */
static size_t goes_on(const Ends *ends, size_t end) {
    size_t other = meets(ends, end);
    return other != SIZE_MAX && !ends->used[other / 2] ? other : SIZE_MAX;
}

typedef struct Chain {
    Vec2 *points;
    size_t count, capacity;
} Chain;

/* Adds a point; a point on a straight continuation is dropped. */
static void chain_add(Chain *chain, Vec2 at) {
    if (chain->count > 1) {
        Vec2 last = chain->points[chain->count - 1], before = chain->points[chain->count - 2];
        Vec2 in = vec2_unit(vec2_sub(last, before)), out = vec2_unit(vec2_sub(at, last));
        if (vec2_dot(in, out) > 0 && fabs(vec2_cross(in, out)) < STRAIGHT)
            chain->count--;
    }
    chain->points = memory_reserve(chain->points, &chain->capacity, chain->count + 1, sizeof *chain->points);
    chain->points[chain->count++] = at;
}

/* Returns the end where the chain of a line begins, found by walking against the line's direction; a closed chain
 * begins with the line itself. */
static size_t find_beginning(Ends *ends, size_t line) {
    size_t begin = 2 * line;
    ends->used[line] = true; /* ends a closed chain here */
    for (size_t other = goes_on(ends, begin); other != SIZE_MAX; other = goes_on(ends, begin)) {
        ends->used[other / 2] = true;
        begin = other ^ 1;
    }
    bool closed = meets(ends, begin) == 2 * line + 1;
    for (size_t end = begin;;) { /* walk the chain again from its beginning */
        ends->used[end / 2] = false;
        if (end / 2 == line)
            return closed ? 2 * line : begin;
        size_t a = ends->first[ends->place_of[end ^ 1]];
        end = a == (end ^ 1) ? ends->after[a] : a;
    }
}

static void add_chain(HouseBuilder *builder, Ends *ends, size_t line, Chain *chain) {
    size_t begin = find_beginning(ends, line);
    const WallLine *kind = &ends->lines[line];
    chain->count = 0;
    chain_add(chain, ends->places[ends->place_of[begin]]);
    for (size_t end = begin; end != SIZE_MAX; end = goes_on(ends, end ^ 1)) {
        ends->used[end / 2] = true;
        chain_add(chain, ends->places[ends->place_of[end ^ 1]]);
    }
    house_builder_wall(builder, chain->points, chain->count, kind->thickness, kind->height);
}

size_t wall_chains_add(HouseBuilder *builder, const WallLine *lines, size_t count) {
    for (size_t l = 0; l < count; l++)
        if (!house_builder_good(builder, lines[l].a) || !house_builder_good(builder, lines[l].b))
            return 0;
    Ends ends = ends_find(lines, count);
    size_t doubled = 0;
    Chain chain = {0};
    for (size_t l = 0; l < count; l++)
        doubled += ends.used[l] && ends.place_of[2 * l] != ends.place_of[2 * l + 1];
    for (size_t l = 0; l < count && !builder->failed; l++)
        if (!ends.used[l])
            add_chain(builder, &ends, l, &chain);
    memory_free(chain.points);
    ends_free(&ends);
    return doubled;
}

void wall_chains_append(WallLines *lines, WallLine line) {
    lines->list = memory_reserve(lines->list, &lines->capacity, lines->count + 1, sizeof *lines->list);
    lines->list[lines->count++] = line;
}

size_t wall_chains_arc(Vec2 centre, Vec2 from, double sweep, Vec2 points[WALL_CHAINS_ARC]) {
    Vec2 arm = vec2_sub(from, centre);
    double radius = vec2_length(arm), step = radius > ARC_DEVIATION ? 2 * real_acos(1 - ARC_DEVIATION / radius) : M_PI;
    double pieces = ceil(fabs(sweep) / fmin(step, M_PI / 6));
    size_t count = pieces >= 1 ? (size_t)fmin(pieces, WALL_CHAINS_ARC) : 1; /* 1 also for NaN */
    for (size_t i = 0; i < count; i++)
        points[i] = vec2_add(centre, vec2_turn(arm, vec2_heading(sweep * (double)(i + 1) / (double)count)));
    return count;
}
