/* Bytes that arrive piece by piece: the output of a library, kept in memory until it is complete. */
#pragma once

#include <stddef.h>

/* Zero is empty; memory_free(bytes.at) releases it. */
typedef struct Bytes {
    char *at; /* (size), followed by a 0 */
    size_t size, capacity;
} Bytes;

void bytes_add(Bytes *bytes, const void *more, size_t size);
