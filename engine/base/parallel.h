/* Independent pieces of work on several threads. */
#pragma once

#include <stddef.h>

/* Calls `work(context, i)` once for every i below `count`, on up to `jobs` threads (1: on this one). Which thread does
 * which piece is not determined: a piece may write only what is its own. */
void parallel_for(int jobs, size_t count, void (*work)(void *context, size_t i), void *context);

/* How many processors there are for this program. */
int parallel_processors(void);
