/* Comparison functions for qsort. They are total orders: qsort may leave equal elements in any order, which differs
 * from one C library to the next, so only elements of the same bits are equal. */
#pragma once

#include <math.h>

/* Orders doubles from small to large: -0 before 0, and values that are not numbers last. */
static inline int order_rising(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    if (x < y || x > y)
        return x < y ? -1 : 1;
    return x == y ? !!signbit(y) - !!signbit(x) : !!isnan(x) - !!isnan(y);
}
