/* Periodic orbits, found and certified on the Poincare map x -> P(x), one cycle of the drive from phase 0 to phase 0.
 *
 * Newton's iteration on P^p(x) = x with the exact derivative (tangents with saltation) finds the orbit whether or not
 * it is stable; the eigenvalues of the derivative, its multipliers, tell which: inside the unit circle, it attracts. */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#include "beam/motion.h"

enum { ORBIT_PERIOD_MOST = 16 /* cycles */ };

/* How a multiplier leaves the unit circle names what becomes of the orbit. */
typedef enum OrbitLeaving {
    ORBIT_FOLD,    /* through +1: it meets another and both are gone, or it parts with its mirror image */
    ORBIT_FLIP,    /* through -1: its period doubles */
    ORBIT_NEIMARK, /* as a pair: a torus */
} OrbitLeaving;

typedef struct Orbit {
    size_t period; /* cycles */
    size_t states;
    double *point;                         /* (states) at phase 0 */
    double *multiplier_re, *multiplier_im; /* (states) largest first */
    double largest;                        /* |multiplier| */
    OrbitLeaving leaving;                  /* which of the three the largest is nearest to */
    double error;                          /* |P^p(x) - x| / |x| that Newton's iteration left */
} Orbit;

/* Newton's iteration from `start` (states) for an orbit of `period` cycles, or of a divisor of it. False: it does not
 * converge or is stopped (`stop` other than 0; NULL: nothing stops it), and there is nothing to clear. */
bool orbit_find(Orbit *orbit, const Rig *rig, const double *start, size_t period, const volatile sig_atomic_t *stop);

/* Does it attract: are all multipliers inside the unit circle? */
bool orbit_is_stable(const Orbit *orbit);

/* sqrt(J), how far a state is from the orbit's nearest point at phase 0, of its length. */
double orbit_distance(const Orbit *orbit, const Rig *rig, const double *state);

void orbit_clear(Orbit *orbit);

/* P^cycles(x) into `state`, and its derivative (states x states, column by column), unless NULL. False: it chatters,
 * diverges or is stopped. */
bool orbit_map(const Rig *rig, double *state, size_t cycles, double *derivative, const volatile sig_atomic_t *stop);
