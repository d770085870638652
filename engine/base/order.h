/* Comparison functions for qsort. */
#pragma once

/* Orders doubles from small to large. */
static inline int order_rising(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
