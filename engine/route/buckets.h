/* Points of a grid in the order of their times, roughly: Dial's buckets (1969), each of the same width in time, used
 * cyclically. In a bucket the last point that came is the first to go. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"

typedef struct BucketEntry {
    int point;
    int next;   /* next entry in the same bucket, or among the unused; -1: none */
    float time; /* s */
} BucketEntry;

/* buckets_make and buckets_clear. */
typedef struct Buckets {
    BucketEntry *entries;
    size_t capacity, used;
    int unused;
    int *heads;        /* (last + 1) */
    size_t last;       /* index of the last bucket, a power of two less one: as many buckets hold points at one time */
    size_t held;       /* points */
    double per_second; /* buckets */
} Buckets;

/* Makes empty buckets of `width` s for points whose times differ by up to `span` s. */
static inline Buckets buckets_make(double width, double span) {
    Buckets buckets = {.unused = -1, .last = 1, .per_second = 1 / width};
    while ((double)buckets.last < span / width + 2)
        buckets.last = 2 * buckets.last + 1;
    buckets.heads = memory_zeroed(buckets.last + 1, sizeof *buckets.heads);
    for (size_t b = 0; b <= buckets.last; b++)
        buckets.heads[b] = -1;
    return buckets;
}

static inline void buckets_clear(Buckets *buckets) {
    memory_free(buckets->entries);
    memory_free(buckets->heads);
    *buckets = (Buckets){0};
}

/* Returns the number of the bucket of a time, counted from time 0; that of an earlier time is 0. */
static inline size_t buckets_number(const Buckets *buckets, float time) {
    return time > 0 ? (size_t)((double)time * buckets->per_second) : 0;
}

static inline void buckets_put(Buckets *buckets, int point, float time) {
    int place = buckets->unused;
    if (place >= 0) {
        buckets->unused = buckets->entries[place].next;
    } else {
        buckets->entries =
            memory_reserve(buckets->entries, &buckets->capacity, buckets->used + 1, sizeof *buckets->entries);
        place = (int)buckets->used++;
    }
    int *head = &buckets->heads[buckets_number(buckets, time) & buckets->last];
    buckets->entries[place] = (BucketEntry){point, *head, time};
    *head = place;
    buckets->held++;
}

/* Removes a point from the bucket of a number; false: it is empty. */
static inline bool buckets_take(Buckets *buckets, size_t number, int *point, float *time) {
    int *head = &buckets->heads[number & buckets->last], place = *head;
    if (place < 0)
        return false;
    BucketEntry *entry = &buckets->entries[place];
    *point = entry->point;
    *time = entry->time;
    *head = entry->next;
    entry->next = buckets->unused;
    buckets->unused = place;
    buckets->held--;
    return true;
}
