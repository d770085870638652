/* Regimes: the beam free, and the beam in contact, are linear; each is solved exactly by its eigenvalues.
 *
 * A state is (omega_i q_i, q_i'), 2 n numbers in sqrt(J), so that half its squared length is the energy of the free
 * beam. In a regime it obeys x' = A x + forces,
 *
 *     A = |          0                  Omega        |      k, c of the contact, 0 when free; b = phi(tip);
 *         | -Omega - k b b'/Omega   -damping - c b b' |      D the modes' damping
 *
 * and with A v = lambda v each pair of conjugate eigenvalues, and each real one, is a block: one complex number Z with
 * Z(t) = Z(0) exp(lambda t), x = Re sum v Z, Z = w x. A harmonic force adds a steady part, found exactly; nothing is
 * integrated by steps. At exactly critical damping two eigenvalues meet; rounding holds them apart, and what is left of
 * the precision there is 1e-8. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "beam/modes.h"
#include "mechanics/contact.h"

/* Complex numbers, real and imaginary parts apart. */
typedef struct RegimeVector {
    double *re, *im;
} RegimeVector;

/* What is measured of a state: y = Re sum row Z. */
typedef enum RegimeRow {
    REGIME_TIP,   /* m, deflection of the tip */
    REGIME_FORCE, /* N, k deflection + c velocity of the tip: the contact's force, but for what the clearance takes */
    REGIME_ROWS,
} RegimeRow;

enum { REGIME_ORDERS = 3 /* a row, its first and its second rate */ };

typedef struct Regime {
    size_t states, blocks;                        /* 2 n; at most as many */
    RegimeVector lambda;                          /* (blocks) 1/s */
    RegimeVector shape;                           /* (states x blocks) v */
    RegimeVector part;                            /* (states x blocks) w */
    RegimeVector drive;                           /* (blocks) what 1 N at the shaker gives */
    RegimeVector push;                            /* (blocks) what 1 N at the tip gives */
    RegimeVector row[REGIME_ROWS][REGIME_ORDERS]; /* (blocks) */
    double *memory;
} Regime;

/* The regime of modes whose tip is held by `law`; `held` false: free, and the law only makes the row of the force.
 * False: LAPACK found no eigenvalues, and there is nothing to clear. */
bool regime_build(Regime *regime, const Modes *modes, const ContactLaw *law, bool held);

void regime_clear(Regime *regime);

/* Room for `count` complex numbers; memory_free its `re`. */
RegimeVector regime_vector(size_t count);

/* exp(lambda time) of each block. */
void regime_propagator(const Regime *regime, double time, RegimeVector factor);

/* Z *= factor. */
static inline void regime_advance(size_t blocks, const double *restrict factor_re, const double *restrict factor_im,
                                  double *restrict re, double *restrict im) {
    for (size_t j = 0; j < blocks; j++) {
        double real = re[j] * factor_re[j] - im[j] * factor_im[j];
        im[j] = re[j] * factor_im[j] + im[j] * factor_re[j];
        re[j] = real;
    }
}

/* Re sum row Z. */
static inline double regime_measure(size_t blocks, RegimeVector row, RegimeVector z) {
    double sum = 0;
    for (size_t j = 0; j < blocks; j++)
        sum += row.re[j] * z.re[j] - row.im[j] * z.im[j];
    return sum;
}

/* The state of blocks, and the blocks of a state. */
void regime_state(const Regime *regime, RegimeVector z, double *state);
void regime_blocks(const Regime *regime, const double *state, RegimeVector z);

/* The trace of A, 1/s: the sum of all its eigenvalues. */
double regime_trace(const Regime *regime);
