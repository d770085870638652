/* How qsort is told to put numbers in order. */
#pragma once

/* Rising, of doubles. */
static inline int order_rising(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
