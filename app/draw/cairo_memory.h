/* Pictures that cairo paints into memory: it leaves out what it has no memory for, and says so only when asked. */
#pragma once

struct _cairo; /* cairo's own name of cairo_t */

/* Ends the program as memory_end does if there was no memory for something that was painted. */
void cairo_memory_check(struct _cairo *cairo);

/* Checks the memory, then releases the context. */
void cairo_memory_end(struct _cairo *cairo);
