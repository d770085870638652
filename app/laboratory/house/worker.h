/* A thread that computes runs, one at a time. */
#pragma once

#include "laboratory/house/run.h"

typedef struct HouseWorker HouseWorker;

/* Starts a worker; `low`: its runs give way to all other work of the machine. NULL: the system has no more threads.
 * house_worker_destroy stops the run in progress and waits
 * for its end; all runs must have been abandoned. */
HouseWorker *house_worker_create(bool low);
void house_worker_destroy(HouseWorker *worker);

/* Queues a run for the thread; runs are computed in the order of their jobs. Each job has at most one run that has
 * not begun: abandon that one before queueing another. */
void house_worker_ask(HouseWorker *worker, HouseRun *run);

/* Abandons a run: the worker releases it as soon as possible. NULL has no effect. */
void house_worker_abandon(HouseWorker *worker, HouseRun *run);
