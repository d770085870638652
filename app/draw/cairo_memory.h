/* Pictures that cairo paints into memory: without memory it would leave parts of them out, and say so only when asked.
 */
#pragma once

struct _cairo; /* cairo's own names */
struct _cairo_surface;

/* End the program as memory_end does if there was no memory for something that was painted, or for the surface. */
void cairo_memory_check(struct _cairo *cairo);
void cairo_memory_check_surface(struct _cairo_surface *surface);

/* Checks the memory and releases the context. */
void cairo_memory_end(struct _cairo *cairo);
