/* Many motions of one beam at once, side by side in the lanes of vector instructions: a sweep, a basin, a map. They
 * share modes, regimes and propagators, which depend neither on frequency, force, clearance nor start.
 *
 * A motion's results do not depend on which others are beside it, nor on how wide the machine's vectors are. */
#pragma once

#include <signal.h>

#include "beam/motion.h"

typedef struct LanesRun {
    double frequency;    /* Hz */
    double force;        /* N */
    double clearance;    /* m */
    const double *start; /* (states) at phase 0; NULL: at rest */
    int transient_cycles, cycles;

    /* What comes of it; arrays are the caller's, NULL: not wanted. */
    MotionStatus status;
    size_t recorded;    /* cycles, fewer than `cycles` when it chatters, diverges or is stopped */
    double *peak;       /* (cycles x 2) N, largest force of each recorded cycle on the upper and the lower side */
    double *deflection; /* (cycles) m, of the tip at the end of each recorded cycle, phase 0 */
    double *velocity;   /* (cycles) m/s */
    double *section;    /* (cycles x states) sqrt(J) */
    double *end;        /* (states) the last state */
} LanesRun;

/* Makes the runs (count) of the beam that the rig is of, whatever the rig's own drive and clearance are. `stop` as
 * everywhere. */
void lanes_run(const Rig *rig, LanesRun *runs, size_t count, const volatile sig_atomic_t *stop);
