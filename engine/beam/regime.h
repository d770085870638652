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
 * integrated by steps. Where two eigenvalues meet, as at critical damping, their vectors are parallel: there the beam
 * and its contact are damped by 1e-9 more than they should be, and that is then the precision.
 *
 * Motions go by cells, cut into parts so short that |lambda| times half a part is small: exp(lambda t) is a table's
 * entry at the nearest cut times a polynomial, exact to rounding, and what is measured is a polynomial in time about a
 * cut. Neither knows the drive, so that they serve all frequencies, forces and clearances. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "beam/modes.h"
#include "mechanics/contact.h"

/* Complex numbers with separate real and imaginary parts. */
typedef struct RegimeVector {
    double *re, *im;
} RegimeVector;

/* Observed quantities of a state: y = Re sum row Z. */
typedef enum RegimeRow {
    REGIME_TIP,   /* m, deflection of the tip */
    REGIME_FORCE, /* N, k deflection + c velocity of the tip: the contact's force plus the constant k times clearance */
    REGIME_ROWS,
} RegimeRow;

/* The number of blocks is a multiple of four, the last ones empty: each sum over blocks is four interleaved partial
 * sums with any vector instructions. */
enum { REGIME_WIDTH = 4 };

/* Terms of a Taylor polynomial about a cut: the next would be 1e-17 of a block's size. */
enum { REGIME_TERMS = 8 };

/* Largest |lambda| times the length of a part. */
#define REGIME_PART (M_PI / 128)

typedef struct Regime {
    size_t states, blocks;            /* 2 n; a multiple of REGIME_WIDTH */
    RegimeVector lambda;              /* (blocks) 1/s; 0: empty block */
    RegimeVector shape;               /* (states x blocks) v */
    RegimeVector part;                /* (states x blocks) w */
    RegimeVector drive;               /* (blocks) response to 1 N at the shaker */
    RegimeVector push;                /* (blocks) response to 1 N at the tip */
    RegimeVector row[REGIME_ROWS][2]; /* (blocks) the row, and its rate: row lambda */
    double *terms[REGIME_ROWS];       /* (blocks x 2 x REGIME_TERMS) Re, Im of row lambda^m / m! */
    double *memory;

    double cell;      /* s */
    size_t cuts;      /* number of parts of a cell */
    RegimeVector hop; /* (cuts + 1 x blocks) exp(lambda cell k / cuts) */
} Regime;

/* Builds the regime of modes whose tip is held by `law`; with `held` false the tip is free, and the law only defines
 * the force row. Returns false, with nothing to clear, if the eigenproblem has no solution. */
bool regime_build(Regime *regime, const Modes *modes, const ContactLaw *law, bool held);

void regime_clear(Regime *regime);

/* Return the largest |Im lambda| and the largest |lambda|, 1/s. */
double regime_fastest(const Regime *regime);
double regime_largest(const Regime *regime);

/* Builds the table for cells of `cell` s in `cuts` parts. */
void regime_cut(Regime *regime, double cell, size_t cuts);

static inline size_t regime_nearest_cut(const Regime *regime, double time) {
    return (size_t)(time / regime->cell * (double)regime->cuts + 0.5);
}

/* s. */
static inline double regime_cut_time(const Regime *regime, size_t cut) {
    return regime->cell * (double)cut / (double)regime->cuts;
}

/* Returns exp(lambda time) at a cut, (blocks). */
static inline RegimeVector regime_hop(const Regime *regime, size_t cut) {
    return (RegimeVector){regime->hop.re + cut * regime->blocks, regime->hop.im + cut * regime->blocks};
}

/* Allocates `count` complex numbers; memory_free their `re`. */
RegimeVector regime_vector(size_t count);

/* Computes exp(lambda time) of each block for a time from 0 to a cell. */
void regime_propagator(const Regime *regime, double time, RegimeVector factor);

/* Two doubles, unaligned: a vector that every processor of this kind supports. */
typedef double RegimeTwo __attribute__((vector_size(16), aligned(8), may_alias));

static inline RegimeTwo *regime_two(const double *at) {
    return (RegimeTwo *)(uintptr_t)at;
}

/* Computes moved = Z factor. */
static inline void regime_advance(size_t blocks, RegimeVector factor, RegimeVector z, RegimeVector moved) {
    for (size_t j = 0; j < blocks; j += 2) {
        RegimeTwo re = *regime_two(z.re + j), im = *regime_two(z.im + j);
        RegimeTwo by_re = *regime_two(factor.re + j), by_im = *regime_two(factor.im + j);
        *regime_two(moved.re + j) = re * by_re - im * by_im;
        *regime_two(moved.im + j) = re * by_im + im * by_re;
    }
}

static inline RegimeTwo regime_product(RegimeVector row, RegimeVector z, size_t j) {
    return *regime_two(row.re + j) * *regime_two(z.re + j) - *regime_two(row.im + j) * *regime_two(z.im + j);
}

/* Returns Re sum row Z. */
static inline double regime_measure(size_t blocks, RegimeVector row, RegimeVector z) {
    RegimeTwo first = {0}, second = {0};
    for (size_t j = 0; j < blocks; j += REGIME_WIDTH) {
        first += regime_product(row, z, j);
        second += regime_product(row, z, j + 2);
    }
    return (first[0] + first[1]) + (second[0] + second[1]);
}

/* Computes the Taylor polynomial: y a time t later is the sum over m of term[m] t^m, for t within a part. */
static inline void regime_expand(const Regime *regime, RegimeRow row, RegimeVector z, double term[REGIME_TERMS]) {
    const double *from = regime->terms[row];
    RegimeTwo sum[REGIME_TERMS / 2] = {{0}};
    for (size_t j = 0; j < regime->blocks; j++, from += 2 * REGIME_TERMS)
        for (int m = 0; m < REGIME_TERMS / 2; m++)
            sum[m] += *regime_two(from + 2 * m) * z.re[j] - *regime_two(from + REGIME_TERMS + 2 * m) * z.im[j];
    for (int m = 0; m < REGIME_TERMS / 2; m++)
        *regime_two(term + 2 * m) = sum[m];
}

/* Convert blocks to a state and a state to blocks. */
void regime_state(const Regime *regime, RegimeVector z, double *state);
void regime_blocks(const Regime *regime, const double *state, RegimeVector z);

/* Returns the trace of A, 1/s: the sum of all its eigenvalues. */
double regime_trace(const Regime *regime);
