#include "beam/regime.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"

/* Builds A for the state (omega q, q'), column by column, of a beam with `scale` times the damping. */
static double *make_matrix(const Modes *modes, double stiffness, double damping, double scale) {
    size_t n = modes->count, size = 2 * n;
    const double *omega = modes->frequency, *tip = modes->tip;
    double *matrix = memory_zeroed(size * size, sizeof *matrix);
    for (size_t c = 0; c < n; c++) {
        matrix[(n + c) * size + c] = omega[c];
        for (size_t r = 0; r < n; r++) {
            matrix[c * size + n + r] = -(r == c ? omega[c] : 0) - stiffness * tip[r] * tip[c] / omega[c];
            matrix[(n + c) * size + n + r] = -scale * (modes->damping[c * n + r] + damping * tip[r] * tip[c]);
        }
    }
    return matrix;
}

typedef struct Eigen {
    double *re, *im; /* (size) the member of a pair with positive imaginary part comes first */
    double *vectors; /* (size x size) for a pair: real part, then imaginary part */
    double *inverse; /* inverse of `vectors` */
} Eigen;

static bool find_eigen(Eigen *eigen, double *matrix, size_t size) {
    lapack_int n = (lapack_int)size;
    lapack_int *pivots = memory_zeroed(size, sizeof *pivots);
    eigen->re = memory_zeroed(2 * size * size + 2 * size, sizeof(double));
    eigen->im = eigen->re + size;
    eigen->vectors = eigen->im + size;
    eigen->inverse = eigen->vectors + size * size;
    bool good =
        LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'V', n, matrix, n, eigen->re, eigen->im, NULL, 1, eigen->vectors, n) == 0;
    memcpy(eigen->inverse, eigen->vectors, size * size * sizeof(double));
    good = good && LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, eigen->inverse, n, pivots) == 0 &&
           LAPACKE_dgetri(LAPACK_COL_MAJOR, n, eigen->inverse, n, pivots) == 0;
    memory_free(pivots);
    return good;
}

/* Stores one block per real eigenvalue or pair. With v = r + i s, x = u r + w s, Z = u - i w. */
static void keep_blocks(Regime *regime, const Eigen *eigen) {
    size_t size = regime->states, blocks = regime->blocks;
    for (size_t column = 0, j = 0; column < size; column++, j++) {
        bool pair = eigen->im[column] != 0;
        regime->lambda.re[j] = eigen->re[column];
        regime->lambda.im[j] = eigen->im[column];
        for (size_t i = 0; i < size; i++) {
            regime->shape.re[i * blocks + j] = eigen->vectors[column * size + i];
            regime->shape.im[i * blocks + j] = pair ? eigen->vectors[(column + 1) * size + i] : 0;
            regime->part.re[i * blocks + j] = eigen->inverse[i * size + column];
            regime->part.im[i * blocks + j] = pair ? -eigen->inverse[i * size + column + 1] : 0;
        }
        column += pair;
    }
}

/* Converts a row over states to a row over blocks, and computes its terms: each is the previous one times lambda /
 * m. */
static void keep_row(Regime *regime, RegimeRow which, const double *over_states) {
    RegimeVector *row = regime->row[which];
    for (size_t j = 0; j < regime->blocks; j++) {
        double re = 0, im = 0, a = regime->lambda.re[j], b = regime->lambda.im[j];
        double *terms = regime->terms[which] + 2 * REGIME_TERMS * j;
        for (size_t i = 0; i < regime->states; i++) {
            re += over_states[i] * regime->shape.re[i * regime->blocks + j];
            im += over_states[i] * regime->shape.im[i * regime->blocks + j];
        }
        row[0].re[j] = re;
        row[0].im[j] = im;
        row[1].re[j] = re * a - im * b;
        row[1].im[j] = re * b + im * a;
        for (int m = 0; m < REGIME_TERMS; m++) {
            terms[m] = re;
            terms[REGIME_TERMS + m] = im;
            double next = (re * a - im * b) / (m + 1);
            im = (re * b + im * a) / (m + 1);
            re = next;
        }
    }
}

static void keep_rows(Regime *regime, const Modes *modes, const ContactLaw *law) {
    size_t n = modes->count;
    double *tip = memory_zeroed(4 * n, sizeof *tip), *force = tip + 2 * n;
    for (size_t i = 0; i < n; i++) {
        tip[i] = modes->tip[i] / modes->frequency[i];
        force[i] = law->normal_stiffness * tip[i];
        force[n + i] = law->normal_damping * modes->tip[i];
    }
    keep_row(regime, REGIME_TIP, tip);
    keep_row(regime, REGIME_FORCE, force);
    memset(tip, 0, 2 * n * sizeof *tip);
    memcpy(tip + n, modes->shaker, n * sizeof *tip);
    regime_blocks(regime, tip, regime->drive);
    memcpy(tip + n, modes->tip, n * sizeof *tip);
    regime_blocks(regime, tip, regime->push);
    memory_free(tip);
}

static RegimeVector take(double **at, size_t count) {
    RegimeVector taken = {*at, *at + count};
    *at += 2 * count;
    return taken;
}

/* Counts the blocks: one per real eigenvalue or pair, rounded up to REGIME_WIDTH. */
static size_t count_blocks(const Eigen *eigen, size_t size) {
    size_t count = 0;
    for (size_t column = 0; column < size; column++, count++)
        column += eigen->im[column] != 0;
    return (count + REGIME_WIDTH - 1) / REGIME_WIDTH * REGIME_WIDTH;
}

/* Returns the 1-norm, the largest column sum. */
static double norm_of(const double *matrix, size_t size) {
    double norm = 0;
    for (size_t c = 0; c < size; c++) {
        double sum = 0;
        for (size_t r = 0; r < size; r++)
            sum += fabs(matrix[c * size + r]);
        norm = fmax(norm, sum);
    }
    return norm;
}

/* Eigenvectors with a larger condition number lose that many digits. */
static const double CONDITION_MOST = 1e6;
/* Relative extra damping where eigenvectors would be parallel. */
static const double NUDGE = 1e-9;

/* Computes eigenvalues and eigenvectors, with extra damping where two eigenvalues coincide. */
static bool find_regime(Eigen *eigen, const Modes *modes, double stiffness, double damping) {
    size_t size = 2 * modes->count;
    for (int nudged = 0;; nudged++) {
        double *matrix = make_matrix(modes, stiffness, damping, 1 + nudged * NUDGE);
        bool good = find_eigen(eigen, matrix, size);
        memory_free(matrix);
        if (nudged || (good && norm_of(eigen->vectors, size) * norm_of(eigen->inverse, size) < CONDITION_MOST))
            return good;
        memory_free(eigen->re);
    }
}

bool regime_build(Regime *regime, const Modes *modes, const ContactLaw *law, bool held) {
    size_t size = 2 * modes->count;
    Eigen eigen;
    bool good = find_regime(&eigen, modes, held ? law->normal_stiffness : 0, held ? law->normal_damping : 0);
    if (good) {
        size_t blocks = count_blocks(&eigen, size);
        *regime = (Regime){.states = size, .blocks = blocks};
        double *at = regime->memory =
            memory_zeroed((4 * size + 6 + REGIME_ROWS * (4 + 2 * REGIME_TERMS)) * blocks, sizeof *at);
        regime->lambda = take(&at, blocks);
        regime->shape = take(&at, size * blocks);
        regime->part = take(&at, size * blocks);
        regime->drive = take(&at, blocks);
        regime->push = take(&at, blocks);
        for (int row = 0; row < REGIME_ROWS; row++) {
            regime->row[row][0] = take(&at, blocks);
            regime->row[row][1] = take(&at, blocks);
            regime->terms[row] = take(&at, REGIME_TERMS * blocks).re;
        }
        keep_blocks(regime, &eigen);
        keep_rows(regime, modes, law);
    }
    memory_free(eigen.re);
    return good;
}

void regime_clear(Regime *regime) {
    memory_free(regime->memory);
    memory_free(regime->hop.re);
    *regime = (Regime){0};
}

RegimeVector regime_vector(size_t count) {
    double *room = memory_zeroed(2 * count + 1, sizeof *room);
    return take(&room, count);
}

double regime_fastest(const Regime *regime) {
    double fastest = 0;
    for (size_t j = 0; j < regime->blocks; j++)
        fastest = fmax(fastest, fabs(regime->lambda.im[j]));
    return fastest;
}

double regime_largest(const Regime *regime) {
    double largest = 0;
    for (size_t j = 0; j < regime->blocks; j++)
        largest = fmax(largest, real_hypot(regime->lambda.re[j], regime->lambda.im[j]));
    return largest;
}

void regime_cut(Regime *regime, double cell, size_t cuts) {
    size_t blocks = regime->blocks;
    memory_free(regime->hop.re);
    regime->cell = cell;
    regime->cuts = cuts;
    regime->hop = regime_vector((cuts + 1) * blocks);
    for (size_t k = 0; k <= cuts; k++)
        for (size_t j = 0; j < blocks; j++) {
            double time = cell * (double)k / (double)cuts, size = real_exp(regime->lambda.re[j] * time);
            SineCosine turn = real_sincos(regime->lambda.im[j] * time);
            regime->hop.re[k * blocks + j] = size * turn.cosine;
            regime->hop.im[k * blocks + j] = size * turn.sine;
        }
}

/* Computes exp(x) for two x of at most REGIME_PART / 2 by Taylor's series: (1 + x + x^2 / 2) + x^3 (1 / 6 + x / 24 +
 * x^2 / 120 + x^3 / 720); the next term would be below 1e-17. */
static inline void exponentials(RegimeTwo x_re, RegimeTwo x_im, RegimeTwo *re, RegimeTwo *im) {
    RegimeTwo square_re = x_re * x_re - x_im * x_im, square_im = 2 * (x_re * x_im);
    RegimeTwo cube_re = square_re * x_re - square_im * x_im, cube_im = square_re * x_im + square_im * x_re;
    RegimeTwo high_re = (1. / 6 + x_re * (1. / 24)) + (square_re * (1. / 120) + cube_re * (1. / 720));
    RegimeTwo high_im = x_im * (1. / 24) + (square_im * (1. / 120) + cube_im * (1. / 720));
    *re = (1 + (x_re + square_re * 0.5)) + (cube_re * high_re - cube_im * high_im);
    *im = (x_im + square_im * 0.5) + (cube_re * high_im + cube_im * high_re);
}

void regime_propagator(const Regime *regime, double time, RegimeVector factor) {
    size_t cut = regime_nearest_cut(regime, time);
    RegimeVector hop = regime_hop(regime, cut);
    double rest = time - regime_cut_time(regime, cut);
    for (size_t j = 0; j < regime->blocks; j += 2) {
        RegimeTwo re, im, by_re = *regime_two(hop.re + j), by_im = *regime_two(hop.im + j);
        exponentials(*regime_two(regime->lambda.re + j) * rest, *regime_two(regime->lambda.im + j) * rest, &re, &im);
        *regime_two(factor.re + j) = re * by_re - im * by_im;
        *regime_two(factor.im + j) = re * by_im + im * by_re;
    }
}

void regime_state(const Regime *regime, RegimeVector z, double *state) {
    for (size_t i = 0; i < regime->states; i++) {
        size_t from = i * regime->blocks;
        state[i] = regime_measure(regime->blocks, (RegimeVector){regime->shape.re + from, regime->shape.im + from}, z);
    }
}

void regime_blocks(const Regime *regime, const double *state, RegimeVector z) {
    memset(z.re, 0, regime->blocks * sizeof *z.re);
    memset(z.im, 0, regime->blocks * sizeof *z.im);
    for (size_t i = 0; i < regime->states; i++)
        for (size_t j = 0; j < regime->blocks; j++) {
            z.re[j] += regime->part.re[i * regime->blocks + j] * state[i];
            z.im[j] += regime->part.im[i * regime->blocks + j] * state[i];
        }
}

double regime_trace(const Regime *regime) {
    double sum = 0;
    for (size_t j = 0; j < regime->blocks; j++)
        sum += (regime->lambda.im[j] != 0 ? 2 : 1) * regime->lambda.re[j];
    return sum;
}
