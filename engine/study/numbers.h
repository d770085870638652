/* Numbers that are computed one by one, such as an observable of many trials, and their order statistics in a memory
 * that does not grow with them. */
#pragma once

#include <stddef.h>

typedef struct Numbers {
    double (*at)(const void *of, size_t i); /* any double; only finite ones count */
    const void *of;
    size_t count;
} Numbers;

static inline double numbers_at(const Numbers *numbers, size_t i) {
    return numbers->at(numbers->of, i);
}

enum { NUMBERS_RANKS_MOST = 16 };

/* Finds the finite numbers with the given ranks (count): rank 0 is the least. Each must be below the number of finite
 * numbers. Goes through the numbers four times; exact. */
void numbers_find(const Numbers *numbers, const size_t *ranks, size_t count, double *found);
