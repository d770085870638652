/* Two independent measures of chaos: Lyapunov exponents from tangent vectors, and the 0-1 test of a recorded series. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "cycle/cycle.h"

/* A Lyapunov exponent and its standard error, per cycle. */
typedef struct ChaosExponent {
    double value, error; /* 1 */
} ChaosExponent;

/* Orthonormalises the tangents (Gram-Schmidt, applied twice) and adds the logarithms of their growth factors to
 * `growth` (tangents). */
void chaos_renew_tangents(CycleMotion *motion, double *growth);

/* Returns the mean growth per cycle over `count` cycles and its standard error, from the means of CHAOS_BATCHES
 * nearly independent batches. */
ChaosExponent chaos_exponent(const double *growth, size_t count);

enum { CHAOS_BATCHES = 20 };

/* Returns the result of the 0-1 test (Gottwald and Melbourne 2009, with the oscillation of the mean removed): the
 * median over 100 values of c of the correlation K of the mean square displacement with time; 0 is regular, 1 is
 * chaotic. Needs at least 100 values; a transient among them resembles chaos. */
double chaos_zero_one(const double *series, size_t count);
