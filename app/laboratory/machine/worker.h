/* Computes for a running machine, on a thread of low priority: the verdict, the orbit diagram
 * coarsely, the type, the rest of the diagram, and whether a motion that is not periodic lasts. The newest question
 * wins. */
#pragma once

#include "laboratory/machine/sweep.h"
#include "laboratory/machine/verdict.h"

#define MACHINE_WORKER_PAUSE 0.3 /* s without a new question before the worker begins */

typedef struct MachineWorker MachineWorker;

/* Starts a worker; `jobs`: number of threads including the caller's. machine_worker_stop ends the work and the thread.
 */
MachineWorker *machine_worker_start(const MachineKind *kind, int jobs);
void machine_worker_stop(MachineWorker *worker);

/* Request a verdict or a diagram; the previous question is cancelled. The texts of the machines must outlive the
 * worker. */
void machine_worker_ask_verdict(MachineWorker *worker, const Machine *machine);
void machine_worker_ask_sweep(MachineWorker *worker, const MachineSweepTask *task);

/* Results since the last call. */
typedef struct MachineNews {
    bool verdict;                                    /* there is a new verdict, or its type is new */
    MachineVerdict result;                           /* valid if `verdict`; the taker must clear it */
    bool swept;                                      /* there are new points of the orbit diagram */
    bool sweep_begins;                               /* the points belong to a new diagram: discard earlier points */
    MachineSweepPoints points[MACHINE_SWEEP_PASSES]; /* the taker must clear them */
    size_t sweep_done, sweep_all;                    /* number of values of the orbit diagram */
    size_t types_done, types_all;                    /* runs while the type is being determined; otherwise 0 */
    bool confirming;                                 /* motions are watched to confirm the verdict */
    bool deciding;                                   /* the verdict is being computed */
} MachineNews;
void machine_worker_take(MachineWorker *worker, MachineNews *news);
