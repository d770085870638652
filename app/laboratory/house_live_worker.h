/* A thread that makes runs, one at a time. */
#pragma once

#include "laboratory/house_live_run.h"

typedef struct HouseWorker HouseWorker;

/* house_live_worker_destroy stops what is in work and waits for that; all runs must have been abandoned. */
HouseWorker *house_live_worker_create(void);
void house_live_worker_destroy(HouseWorker *worker);

/* Has it made as soon as the thread is free; those that are `urgent` come before others. There is at most one of each
 * kind that has not begun: whoever asks for another one abandons that first. */
void house_live_worker_ask(HouseWorker *worker, HouseRun *run, bool urgent);

/* Nobody looks at the run any more: it is released as soon as it can be. NULL is none. */
void house_live_worker_abandon(HouseWorker *worker, HouseRun *run);
