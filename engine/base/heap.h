/* A heap of plain elements, whose first element always comes before all others.
 *
 *     HEAP_DEFINE(open, Open, before)
 *
 * defines open_put, which adds an element to a block that memory_reserve grows, and open_take, which removes and
 * returns the first element (the heap must not be empty), for elements of type Open and `bool before(Open a, Open b)`.
 */
#pragma once

#include <stddef.h>

#include "base/memory.h"

/* Children of each element, side by side: fewer levels than with two, and fewer lines of the cache. */
enum { HEAP_CHILDREN = 4 };

#define HEAP_DEFINE(name_, Type_, before_)                                                                             \
    static void name_##_put(Type_ **heap, size_t *count, size_t *capacity, Type_ element) {                            \
        *heap = memory_reserve(*heap, capacity, *count + 1, sizeof element);                                           \
        size_t i = (*count)++;                                                                                         \
        for (; i > 0 && before_(element, (*heap)[(i - 1) / HEAP_CHILDREN]); i = (i - 1) / HEAP_CHILDREN)               \
            (*heap)[i] = (*heap)[(i - 1) / HEAP_CHILDREN];                                                             \
        (*heap)[i] = element;                                                                                          \
    }                                                                                                                  \
                                                                                                                       \
    static Type_ name_##_take(Type_ *heap, size_t *count) {                                                            \
        Type_ first = heap[0], last = heap[--*count];                                                                  \
        size_t i = 0;                                                                                                  \
        for (size_t child = 1; child < *count; child = HEAP_CHILDREN * i + 1) {                                        \
            size_t end = child + HEAP_CHILDREN < *count ? child + HEAP_CHILDREN : *count;                              \
            for (size_t other = child + 1; other < end; other++)                                                       \
                if (before_(heap[other], heap[child]))                                                                 \
                    child = other;                                                                                     \
            if (!before_(heap[child], last))                                                                           \
                break;                                                                                                 \
            heap[i] = heap[child];                                                                                     \
            i = child;                                                                                                 \
        }                                                                                                              \
        heap[i] = last;                                                                                                \
        return first;                                                                                                  \
    }
