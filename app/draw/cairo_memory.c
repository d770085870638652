#include "draw/cairo_memory.h"

#include <cairo.h>

#include "base/memory.h"

static void check(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY)
        memory_end();
}

void cairo_memory_check(cairo_t *cairo) {
    check(cairo_status(cairo));
}

void cairo_memory_check_surface(cairo_surface_t *surface) {
    check(cairo_surface_status(surface));
}

void cairo_memory_end(cairo_t *cairo) {
    cairo_memory_check(cairo);
    cairo_destroy(cairo);
}
