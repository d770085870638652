/* Computes for a running beam, on a thread of low priority: the verdict, the orbit diagram
 * coarsely, the type, the rest of the diagram. The newest question wins. */
#pragma once

#include "laboratory/beam/sweep.h"
#include "laboratory/beam/verdict.h"

#define BEAM_WORKER_PAUSE 0.3 /* s, that nothing is asked any more before a new question is taken up */

typedef struct BeamWorker BeamWorker;

/* `jobs`: threads in all, the caller's among them. beam_worker_stop ends what is being done, and the thread. */
BeamWorker *beam_worker_start(int jobs);
void beam_worker_stop(BeamWorker *worker);

/* Asks; what was asked before is given up. The texts of the beams must outlive the worker. */
void beam_worker_ask_verdict(BeamWorker *worker, const Beam *beam);
void beam_worker_ask_sweep(BeamWorker *worker, const BeamSweepTask *task);

/* Results since the last call. */
typedef struct BeamNews {
    bool verdict;                              /* a new one, or the type of it */
    BeamVerdict told;                          /* then; the taker's to clear */
    bool swept;                                /* more points of the orbit diagram */
    bool sweep_begins;                         /* those of another one: the points before are void */
    BeamSweepPoints points[BEAM_SWEEP_PASSES]; /* the taker's to clear */
    size_t sweep_done, sweep_all;              /* values of the orbit diagram */
    size_t types_done, types_all;              /* runs, while the type is being determined; else 0 */
    bool telling;                              /* the verdict is on its way */
} BeamNews;
void beam_worker_take(BeamWorker *worker, BeamNews *news);
