/* Points of a grid in the order of their times, roughly: Dial's buckets (1969), each of the same width in time, used
 * cyclically. In a bucket the last point that came is the first to go. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"

typedef struct BucketEntry {
    int point;
    float time; /* s */
} BucketEntry;

typedef struct Bucket {
    BucketEntry *entries; /* (count) */
    size_t count, capacity;
} Bucket;

/* buckets_make and buckets_clear. */
typedef struct Buckets {
    Bucket *all;       /* (last + 1) */
    size_t last;       /* index of the last bucket, a power of two less one: as many buckets hold points at one time */
    size_t held;       /* points */
    double per_second; /* buckets */
} Buckets;

/* Makes empty buckets of `width` s for points whose times differ by up to `span` s. */
static inline Buckets buckets_make(double width, double span) {
    Buckets buckets = {.last = 1, .per_second = 1 / width};
    while ((double)buckets.last < span / width + 2)
        buckets.last = 2 * buckets.last + 1;
    buckets.all = memory_zeroed(buckets.last + 1, sizeof *buckets.all);
    return buckets;
}

static inline void buckets_clear(Buckets *buckets) {
    for (size_t b = 0; buckets->all && b <= buckets->last; b++)
        memory_free(buckets->all[b].entries);
    memory_free(buckets->all);
    *buckets = (Buckets){0};
}

/* Returns the number of the bucket of a time, counted from time 0; that of an earlier time is 0. */
static inline size_t buckets_number(const Buckets *buckets, float time) {
    return time > 0 ? (size_t)((double)time * buckets->per_second) : 0;
}

static inline void buckets_put(Buckets *buckets, int point, float time) {
    Bucket *bucket = &buckets->all[buckets_number(buckets, time) & buckets->last];
    if (bucket->count == bucket->capacity)
        bucket->entries =
            memory_reserve(bucket->entries, &bucket->capacity, bucket->count + 1, sizeof *bucket->entries);
    bucket->entries[bucket->count++] = (BucketEntry){point, time};
    buckets->held++;
}

/* Removes a point from the bucket of a number; false: it is empty. */
static inline bool buckets_take(Buckets *buckets, size_t number, BucketEntry *entry) {
    Bucket *bucket = &buckets->all[number & buckets->last];
    if (!bucket->count)
        return false;
    *entry = bucket->entries[--bucket->count];
    buckets->held--;
    return true;
}
