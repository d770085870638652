/* Simulates many motions of one beam in the lanes of vector instructions: a sweep, a basin, a map. The motions share
 * modes, regimes and propagators, which depend neither on frequency, force, clearance nor initial state.
 *
 * The results of a motion depend neither on the other motions nor on the vector width of the processor. */
#pragma once

#include "base/stop.h"
#include "beam/motion.h"

typedef struct LanesRun {
    double frequency;    /* Hz */
    double force;        /* N */
    double clearance;    /* m */
    const double *start; /* (states) at phase 0; NULL: at rest */
    int transient_cycles, cycles;

    /* Results; the arrays belong to the caller, NULL: not wanted. */
    CycleStatus status;
    size_t recorded;    /* cycles; fewer than `cycles` after chatter, divergence or interruption */
    double *peak;       /* (cycles x 2) N, largest force of each recorded cycle on the upper and the lower side */
    double *deflection; /* (cycles) m, of the tip at the end of each recorded cycle, phase 0 */
    double *velocity;   /* (cycles) m/s */
    double *section;    /* (cycles x states) sqrt(J) */
    double *end;        /* (states) the last state */
} LanesRun;

/* Simulates `count` runs of the rig's beam; the rig's own drive and clearance are ignored. When
 * `stop` is requested, runs that are not complete are CYCLE_GOOD with fewer recorded cycles. */
void lanes_run(const Rig *rig, LanesRun *runs, size_t count, const Stop *stop);
