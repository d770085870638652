/* What cairo writes, kept in memory. */
#pragma once

#include <cairo.h>
#include <stddef.h>

/* Zero is empty; memory_free(bytes.at) releases it. */
typedef struct Bytes {
    char *at; /* (size), and a 0 behind it */
    size_t size, capacity;
} Bytes;

/* A cairo_write_func_t: adds to the Bytes that `context` points at. */
cairo_status_t bytes_keep(void *context, const unsigned char *data, unsigned length);
