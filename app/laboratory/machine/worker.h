/* Computes for a running machine, on a thread of low priority: the verdict, an orbit that is to be followed, the orbit
 * diagram coarsely, the map of types if it is shown, the type, the rest of the diagram, whether a motion that is not
 * periodic lasts, and the types along the diagram. The newest question wins. */
#pragma once

#include "laboratory/machine/lines.h"
#include "laboratory/machine/map_cells.h"
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

/* Requests that the orbit is followed which a motion of the task's machine from `state` (count; 0: from its start)
 * settles on, over the range of the task; the kind must be able to. */
void machine_worker_ask_follow(MachineWorker *worker, const MachineSweepTask *task, const double *state, size_t count);

/* Gives up what was requested last, if it is not done. */
void machine_worker_drop_follow(MachineWorker *worker);

/* Requests the map of a machine; the previous map is cancelled. */
void machine_worker_ask_map(MachineWorker *worker, const Machine *machine);

/* Pauses the map, or goes on with it. */
void machine_worker_pause_map(MachineWorker *worker, bool paused);

/* Cells of a map. */
typedef struct MachineCells {
    double type[MACHINE_MAP_CELLS]; /* TypesKind; NAN: not computed */
    size_t done, all;               /* all: 0 if no map is being computed */
} MachineCells;

/* Types along the diagram. */
typedef struct MachineBands {
    double value[MACHINE_BANDS_MOST], type[MACHINE_BANDS_MOST]; /* (count) ascending; 1 to 3, NAN: unknown */
    size_t count;
    double step; /* from one value to the next */
} MachineBands;

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
    bool followed;                                   /* there is a followed orbit */
    MachineLines lines;                              /* valid if `followed`; the taker must clear them */
    bool following;                                  /* an orbit is being followed */
    bool banded;                                     /* there are new types along the diagram */
    MachineBands bands;                              /* all types of the diagram so far */
    size_t bands_all;                                /* number of types that are told; 0: none is to be told now */
    bool mapped;                                     /* there are new cells of the map */
    MachineCells map;                                /* all of its cells so far */
    bool deciding;                                   /* the verdict is being computed */
} MachineNews;
void machine_worker_take(MachineWorker *worker, MachineNews *news);
