/* Bytes that come piece by piece: what a library writes, kept in memory until all of it is there. */
#pragma once

#include <stddef.h>

/* Zero is empty; memory_free(bytes.at) releases it. */
typedef struct Bytes {
    char *at; /* (size), and a 0 behind it */
    size_t size, capacity;
} Bytes;

void bytes_add(Bytes *bytes, const void *more, size_t size);
