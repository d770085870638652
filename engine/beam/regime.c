#include "beam/regime.h"

#include <assert.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"

/* A of the state (omega q, q'), column by column. */
static double *make_matrix(const Modes *modes, double stiffness, double damping) {
    size_t n = modes->count, size = 2 * n;
    const double *omega = modes->frequency, *tip = modes->tip;
    double *matrix = memory_allocate(size * size, sizeof *matrix);
    for (size_t c = 0; c < n; c++) {
        matrix[(n + c) * size + c] = omega[c];
        for (size_t r = 0; r < n; r++) {
            matrix[c * size + n + r] = -(r == c ? omega[c] : 0) - stiffness * tip[r] * tip[c] / omega[c];
            matrix[(n + c) * size + n + r] = -modes->damping[c * n + r] - damping * tip[r] * tip[c];
        }
    }
    return matrix;
}

typedef struct Eigen {
    double *re, *im; /* (size) a pair's one with the positive imaginary part comes first */
    double *vectors; /* (size x size) of a pair: the real part, then the imaginary one */
    double *inverse; /* of `vectors` */
} Eigen;

static bool find_eigen(Eigen *eigen, double *matrix, size_t size) {
    lapack_int n = (lapack_int)size;
    lapack_int *pivots = memory_allocate(size, sizeof *pivots);
    eigen->re = memory_allocate(2 * size * size + 2 * size, sizeof(double));
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

/* One block a real eigenvalue or pair. With v = r + i s, x = u r + w s, Z = u - i w. */
static void keep_blocks(Regime *regime, const Eigen *eigen) {
    size_t size = regime->states;
    for (size_t column = 0; column < size; column++) {
        bool pair = eigen->im[column] != 0;
        size_t j = regime->blocks++;
        regime->lambda.re[j] = eigen->re[column];
        regime->lambda.im[j] = eigen->im[column];
        for (size_t i = 0; i < size; i++) {
            regime->shape.re[i * size + j] = eigen->vectors[column * size + i];
            regime->shape.im[i * size + j] = pair ? eigen->vectors[(column + 1) * size + i] : 0;
            regime->part.re[i * size + j] = eigen->inverse[i * size + column];
            regime->part.im[i * size + j] = pair ? -eigen->inverse[i * size + column + 1] : 0;
        }
        column += pair;
    }
}

/* A row over states as one over blocks, and its rates: each is the one before times lambda. */
static void keep_row(Regime *regime, RegimeRow which, const double *over_states) {
    RegimeVector *row = regime->row[which], lambda = regime->lambda;
    for (size_t j = 0; j < regime->blocks; j++) {
        for (size_t i = 0; i < regime->states; i++) {
            row[0].re[j] += over_states[i] * regime->shape.re[i * regime->states + j];
            row[0].im[j] += over_states[i] * regime->shape.im[i * regime->states + j];
        }
        for (int order = 1; order < REGIME_ORDERS; order++) {
            double re = row[order - 1].re[j], im = row[order - 1].im[j];
            row[order].re[j] = re * lambda.re[j] - im * lambda.im[j];
            row[order].im[j] = re * lambda.im[j] + im * lambda.re[j];
        }
    }
}

static void keep_rows(Regime *regime, const Modes *modes, const ContactLaw *law) {
    size_t n = modes->count;
    double *tip = memory_allocate(4 * n, sizeof *tip), *force = tip + 2 * n;
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

bool regime_build(Regime *regime, const Modes *modes, const ContactLaw *law, bool held) {
    size_t size = 2 * modes->count;
    double *matrix = make_matrix(modes, held ? law->normal_stiffness : 0, held ? law->normal_damping : 0);
    Eigen eigen;
    bool good = find_eigen(&eigen, matrix, size);
    if (good) {
        *regime = (Regime){.states = size};
        double *at = regime->memory =
            memory_allocate(4 * size * size + (6 + 2 * REGIME_ROWS * REGIME_ORDERS) * size, sizeof *at);
        regime->lambda = take(&at, size);
        regime->shape = take(&at, size * size);
        regime->part = take(&at, size * size);
        regime->drive = take(&at, size);
        regime->push = take(&at, size);
        for (int row = 0; row < REGIME_ROWS; row++)
            for (int order = 0; order < REGIME_ORDERS; order++)
                regime->row[row][order] = take(&at, size);
        keep_blocks(regime, &eigen);
        keep_rows(regime, modes, law);
    }
    memory_free(eigen.re);
    memory_free(matrix);
    return good;
}

void regime_clear(Regime *regime) {
    memory_free(regime->memory);
    *regime = (Regime){0};
}

RegimeVector regime_vector(size_t count) {
    double *room = memory_allocate(2 * count + 1, sizeof *room);
    return take(&room, count);
}

void regime_propagator(const Regime *regime, double time, RegimeVector factor) {
    for (size_t j = 0; j < regime->blocks; j++) {
        double size = exp(regime->lambda.re[j] * time), sine, cosine;
        sincos(regime->lambda.im[j] * time, &sine, &cosine);
        factor.re[j] = size * cosine;
        factor.im[j] = size * sine;
    }
}

void regime_state(const Regime *regime, RegimeVector z, double *state) {
    for (size_t i = 0; i < regime->states; i++) {
        size_t from = i * regime->states;
        state[i] = regime_measure(regime->blocks, (RegimeVector){regime->shape.re + from, regime->shape.im + from}, z);
    }
}

void regime_blocks(const Regime *regime, const double *state, RegimeVector z) {
    memset(z.re, 0, regime->blocks * sizeof *z.re);
    memset(z.im, 0, regime->blocks * sizeof *z.im);
    for (size_t i = 0; i < regime->states; i++)
        for (size_t j = 0; j < regime->blocks; j++) {
            z.re[j] += regime->part.re[i * regime->states + j] * state[i];
            z.im[j] += regime->part.im[i * regime->states + j] * state[i];
        }
}

double regime_trace(const Regime *regime) {
    double sum = 0;
    for (size_t j = 0; j < regime->blocks; j++)
        sum += (regime->lambda.im[j] != 0 ? 2 : 1) * regime->lambda.re[j];
    return sum;
}
