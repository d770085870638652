/* Computes for a running beam, on a thread of low priority: the verdict, the orbit diagram
 * coarsely, the type, the rest of the diagram. The newest question wins. */
#pragma once

#include "laboratory/beam/sweep.h"
#include "laboratory/beam/verdict.h"

#define BEAM_WORKER_PAUSE 0.3 /* s without a new question before the worker begins */

typedef struct BeamWorker BeamWorker;

/* Starts a worker; `jobs`: number of threads including the caller's. beam_worker_stop ends the work and the thread. */
BeamWorker *beam_worker_start(int jobs);
void beam_worker_stop(BeamWorker *worker);

/* Request a verdict or a diagram; the previous question is cancelled. The texts of the beams must outlive the
 * worker. */
void beam_worker_ask_verdict(BeamWorker *worker, const Beam *beam);
void beam_worker_ask_sweep(BeamWorker *worker, const BeamSweepTask *task);

/* Results since the last call. */
typedef struct BeamNews {
    bool verdict;                              /* there is a new verdict, or its type is new */
    BeamVerdict result;                        /* valid if `verdict`; the taker must clear it */
    bool swept;                                /* there are new points of the orbit diagram */
    bool sweep_begins;                         /* the points belong to a new diagram: discard earlier points */
    BeamSweepPoints points[BEAM_SWEEP_PASSES]; /* the taker must clear them */
    size_t sweep_done, sweep_all;              /* number of values of the orbit diagram */
    size_t types_done, types_all;              /* runs while the type is being determined; otherwise 0 */
    bool deciding;                             /* the verdict is being computed */
} BeamNews;
void beam_worker_take(BeamWorker *worker, BeamNews *news);
