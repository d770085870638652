/* Independent pieces of work on several threads. */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

/* A flag that ends work early, set by a signal's handler or by another thread; NULL is never set. */
static inline bool parallel_stopped(const volatile sig_atomic_t *stop) {
    return stop && __atomic_load_n(stop, __ATOMIC_RELAXED);
}

static inline void parallel_stop(volatile sig_atomic_t *stop) {
    __atomic_store_n(stop, 1, __ATOMIC_RELAXED);
}

/* Calls `work(context, i)` once for every i below `count`, on up to `jobs` threads (1: on this one). Which thread does
 * which piece is not determined: a piece may write only what is its own. */
void parallel_for(int jobs, size_t count, void (*work)(void *context, size_t i), void *context);

/* Threads that stay, for work that comes in pieces of microseconds, thousands of times a second. */
typedef struct ParallelTeam ParallelTeam;

/* `jobs` threads, the caller's among them; NULL for one. parallel_team_destroy releases it, NULL too. */
ParallelTeam *parallel_team_create(int jobs);
void parallel_team_destroy(ParallelTeam *team);

/* As parallel_for, by a team of which the calling thread is one; returns when all is done. One call at a time. */
void parallel_team_for(ParallelTeam *team, size_t count, void (*work)(void *context, size_t i), void *context);

/* How many processors there are for this program. */
int parallel_processors(void);
