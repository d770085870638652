/* Is a motion chaotic? Two measures that do not know of each other: Lyapunov exponents of the tangents, and the 0-1
 * test of a recorded series. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "beam/motion.h"

/* A Lyapunov exponent and its standard error, per cycle of the drive. */
typedef struct ChaosExponent {
    double value, error; /* 1 */
} ChaosExponent;

/* Makes the tangents orthonormal again (Gram and Schmidt, twice) and adds the logarithms of what they had grown by to
 * `growth` (tangents). */
void chaos_renew_tangents(Motion *motion, double *growth);

/* Mean of the growths of single cycles (count), and its standard error from the means of CHAOS_BATCHES batches, whose
 * neighbours hardly know of each other. */
ChaosExponent chaos_exponent(const double *growth, size_t count);

enum { CHAOS_BATCHES = 20 };

/* The exponents' sum as it must be, 1/s: the trace of what damps, -2 sum zeta omega - c (phi phi) times the share of
 * the time in contact, for a release at zero force. */
double chaos_exponent_sum(const Rig *rig, double contact_share);

/* The 0-1 test (Gottwald and Melbourne 2009, with the mean's oscillation taken away): median over 100 values of c of
 * the correlation K of the mean square displacement with time: 0 regular, 1 chaotic. Asks for a hundred values or more;
 * a transient among them looks like chaos. */
double chaos_zero_one(const double *series, size_t count);
