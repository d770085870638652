/* Runs independent pieces of work on several threads. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Calls `work(context, i)` once for every i below `count`, on up to `jobs` threads (1: on the calling thread). The
 * assignment of pieces to threads is not determined, so a piece may write only its own data. */
void parallel_for(int jobs, size_t count, void (*work)(void *context, size_t i), void *context);

/* A team of permanent threads, for work in pieces of microseconds, thousands of times per second. */
typedef struct ParallelTeam ParallelTeam;

/* Creates a team of `jobs` threads, including the caller; returns NULL for one. parallel_team_destroy releases it and
 * accepts NULL. */
ParallelTeam *parallel_team_create(int jobs);
void parallel_team_destroy(ParallelTeam *team);

/* Works as parallel_for with the threads of a team, including the calling thread, and returns when all pieces are done.
 * Only one call at a time. */
void parallel_team_for(ParallelTeam *team, size_t count, void (*work)(void *context, size_t i), void *context);

/* Returns the number of processors available to this program. */
int parallel_processors(void);
