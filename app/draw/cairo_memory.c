#include "draw/cairo_memory.h"

#include <cairo.h>

#include "base/memory.h"

void cairo_memory_check(cairo_t *cairo) {
    if (cairo_status(cairo) == CAIRO_STATUS_NO_MEMORY)
        memory_end();
}

void cairo_memory_end(cairo_t *cairo) {
    cairo_memory_check(cairo);
    cairo_destroy(cairo);
}
