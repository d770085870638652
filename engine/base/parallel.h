/* Independent pieces of work on several threads. */
#pragma once

#include <stddef.h>

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
