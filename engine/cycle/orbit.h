/* Periodic orbits, found and certified on the Poincare map x -> P(x), one cycle.
 *
 * Newton's iteration on P^p(x) = x with the exact derivative (tangents with saltation) finds stable and unstable
 * orbits; an orbit is stable if the eigenvalues of the derivative, its multipliers, lie inside the unit circle. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "cycle/cycle.h"

enum { ORBIT_PERIOD_MOST = 16 /* cycles */, ORBIT_LOCKED_MOST = 256 /* cycles, of a torus that is locked */ };

#define ORBIT_SETTLED 1e-3 /* fraction of a state's length: a motion this close to an orbit has settled on it */

/* The bifurcation named by the point at which a multiplier leaves the unit circle. */
typedef enum OrbitLeaving {
    ORBIT_FOLD,    /* through +1: two orbits meet and vanish, or the orbit loses its mirror symmetry */
    ORBIT_FLIP,    /* through -1: the period doubles */
    ORBIT_NEIMARK, /* as a complex pair: a torus */
} OrbitLeaving;

/* Mirror images (CycleKind's mirror). Twice the mirror image is a motion one cycle later: an orbit that is its own
 * image has an odd period, and one of an even period always has another one beside it. */
typedef enum OrbitImage {
    ORBIT_IMAGE_NONE, /* the cycle has no such symmetry */
    ORBIT_IMAGE_OWN,
    ORBIT_IMAGE_OTHER, /* another orbit: the two are a pair, with the forces of both sides exchanged */
} OrbitImage;

#define ORBIT_APART 1e-6 /* fraction of a state's length: orbits farther apart are two */

typedef enum OrbitAnswer {
    ORBIT_GOOD,
    ORBIT_NONE, /* the iteration does not converge, or the motion chatters or diverges */
    ORBIT_INTERRUPTED,
} OrbitAnswer;

typedef struct Orbit {
    size_t period; /* cycles */
    size_t states;
    double *point;                         /* (states) at the cycle's end */
    double *multiplier_re, *multiplier_im; /* (states) in order of decreasing magnitude */
    double largest;                        /* |multiplier| */
    OrbitLeaving leaving;                  /* the bifurcation that the largest multiplier is nearest to */
    double error;                          /* remaining |P^p(x) - x| / |x| */
} Orbit;

/* Runs Newton's iteration from `start` (states) for an orbit of `period` cycles or of a divisor of it. There is
 * an orbit, which orbit_clear releases, only with ORBIT_GOOD. `stop` NULL: never. */
__attribute__((warn_unused_result)) OrbitAnswer orbit_find(Orbit *orbit, Cycle cycle, const double *start,
                                                           size_t period, const Stop *stop);

/* Finds the stable orbit that a motion has settled on, or is settling on: of `period` cycles or a divisor of it, no
 * farther from `state` than the fraction `near` of its length, with its own period. */
__attribute__((warn_unused_result)) OrbitAnswer orbit_settle(Orbit *orbit, Cycle cycle, const double *state,
                                                             size_t period, double near, const Stop *stop);

/* True if all multipliers lie inside the unit circle. */
bool orbit_is_stable(const Orbit *orbit);

/* Returns the distance of a state from the orbit's nearest point at a cycle's end, as a fraction of that point's
 * length; meaningless when `stop`, which may be NULL, is requested. */
double orbit_distance(const Orbit *orbit, Cycle cycle, const double *state, const Stop *stop);

/* Tells what the mirror image of the orbit is; meaningless when `stop`, which may be NULL, is requested. */
OrbitImage orbit_image(const Orbit *orbit, Cycle cycle, const Stop *stop);

/* Returns the largest force on the orbit, N; 0: it is without contact. Meaningless when `stop`, which may be NULL, is
 * requested. */
double orbit_peak(const Orbit *orbit, Cycle cycle, const Stop *stop);

void orbit_clear(Orbit *orbit);

/* Computes P^cycles(x) into `state` and, unless NULL, its derivative (states x states, column by column). */
OrbitAnswer orbit_map(Cycle cycle, double *state, size_t cycles, double *derivative, const Stop *stop);
