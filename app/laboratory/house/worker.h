/* A thread that makes runs, one at a time. */
#pragma once

#include "laboratory/house/run.h"

typedef struct HouseWorker HouseWorker;

/* NULL: the system has no more threads. house_worker_destroy stops the run in work and waits for it; all runs must
 * have been abandoned. */
HouseWorker *house_worker_create(void);
void house_worker_destroy(HouseWorker *worker);

/* Has it made as soon as the thread is free, in the order of the jobs. Of each job there is at most one that has not
 * begun: whoever asks for another one abandons that first. */
void house_worker_ask(HouseWorker *worker, HouseRun *run);

/* Nobody looks at the run any more: it is released as soon as it can be. NULL is none. */
void house_worker_abandon(HouseWorker *worker, HouseRun *run);
