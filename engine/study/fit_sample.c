#include "study/fit_sample.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/normal.h"
#include "base/random.h"
#include "base/real.h"

static const double WIDENED = 1.5, DEFENCE = 0.1, SPREAD_OUT = 2; /* SPREAD_OUT: of the covariance */
static const double LEAST_VARIANCE = 1e-8;                        /* squared spreads */

enum { U = FIT_UNKNOWNS_MOST, ALL = FIT_SAMPLE_ROUNDS * FIT_SAMPLE_ROUND };

/* A normal proposal; the logarithm of its density leaves out that of the constant 2 pi. */
typedef struct Proposal {
    double mean[U], factor[U * U]; /* lower triangle of the covariance's Cholesky factor, by columns */
    double log_size;               /* of the factor's determinant */
} Proposal;

static double log_density(const Proposal *proposal, const double *u, size_t n) {
    double square = 0, z[U];
    for (size_t i = 0; i < n; i++) {
        z[i] = u[i] - proposal->mean[i];
        for (size_t k = 0; k < i; k++)
            z[i] -= proposal->factor[k * n + i] * z[k];
        z[i] /= proposal->factor[i * n + i];
        square += z[i] * z[i];
    }
    return -square / 2 - proposal->log_size;
}

static Proposal first_proposal(size_t n) {
    Proposal proposal = {.log_size = (double)n * real_log(WIDENED)};
    for (size_t i = 0; i < n; i++)
        proposal.factor[i * n + i] = WIDENED;
    return proposal;
}

/* Returns the share of the mixture of the proposals of `rounds` at u, relative to `most`, the largest log density. */
static double mixture(const Proposal *proposals, size_t rounds, const double *u, size_t n) {
    double whole = 0;
    for (size_t k = 0; k < rounds; k++) {
        double own = real_exp(log_density(&proposals[k], u, n));
        whole += k ? (1 - DEFENCE) * own + DEFENCE * real_exp(log_density(&proposals[0], u, n)) : own;
    }
    return whole / (double)rounds;
}

static double effective_of(const double *logs, size_t count, double power, double *weight) {
    double most = -HUGE_VAL, sum = 0, squares = 0;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, logs[i]);
    for (size_t i = 0; i < count; i++)
        sum += weight[i] = real_exp(power * (logs[i] - most));
    for (size_t i = 0; i < count; i++) {
        weight[i] /= sum;
        squares += weight[i] * weight[i];
    }
    return 1 / squares;
}

/* Weighs the samples, flattened so that at least `least` count; returns how many count without. */
static double weigh(FitSamples *samples, const Proposal *proposals, size_t rounds, size_t n, double least) {
    double *logs = memory_zeroed(samples->count, sizeof *logs);
    for (size_t i = 0; i < samples->count; i++)
        logs[i] = -samples->sum[i] / 2 - real_log(mixture(proposals, rounds, samples->at + i * U, n));
    double effective = effective_of(logs, samples->count, 1, samples->weight), power = 1;
    while (least > 0 && effective_of(logs, samples->count, power, samples->weight) < least && power > 1e-3)
        power *= 0.8;
    memory_free(logs);
    return effective;
}

void fit_sample_moments(const FitSamples *samples, size_t n, double *mean, double *covariance) {
    memset(mean, 0, n * sizeof *mean);
    memset(covariance, 0, n * n * sizeof *covariance);
    for (size_t s = 0; s < samples->count; s++)
        for (size_t i = 0; i < n; i++)
            mean[i] += samples->weight[s] * samples->at[s * U + i];
    for (size_t s = 0; s < samples->count; s++)
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                covariance[j * n + i] +=
                    samples->weight[s] * (samples->at[s * U + i] - mean[i]) * (samples->at[s * U + j] - mean[j]);
}

/* Makes the normal proposal that follows from the weighted samples; false: their covariance is none. */
static bool next_proposal(const FitSamples *samples, size_t n, Proposal *proposal) {
    *proposal = (Proposal){0};
    fit_sample_moments(samples, n, proposal->mean, proposal->factor);
    for (size_t i = 0; i < n * n; i++)
        proposal->factor[i] *= SPREAD_OUT;
    for (size_t i = 0; i < n; i++)
        proposal->factor[i * n + i] += LEAST_VARIANCE;
    if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', (lapack_int)n, proposal->factor, (lapack_int)n) != 0)
        return false;
    for (size_t i = 0; i < n; i++)
        proposal->log_size += real_log(proposal->factor[i * n + i]);
    return true;
}

/* Adds the samples of a round. */
static bool draw_round(FitSamples *samples, FitSearch *search, const Proposal *proposals, size_t round) {
    size_t n = search->fit->unknown_count;
    Random random = random_seed(1, round + 1);
    double *at = samples->at + samples->count * U;
    for (size_t s = 0; s < FIT_SAMPLE_ROUND; s++) {
        bool wide = round == 0 || random_uniform(&random) < DEFENCE;
        const Proposal *from = wide ? &proposals[0] : &proposals[round];
        double z[U], place[U];
        fit_search_kronecker(n, s + 1, place);
        for (size_t i = 0; i < n; i++)
            z[i] = round == 0 ? normal_quantile(fmin(fmax(place[i], 1e-3), 1 - 1e-3)) : random_normal(&random, 0, 1);
        for (size_t i = 0; i < n; i++) {
            double u = from->mean[i];
            for (size_t k = 0; k <= i; k++)
                u += from->factor[k * n + i] * z[k];
            at[s * U + i] = u;
        }
    }
    bool good = fit_search_sums(search, at, FIT_SAMPLE_ROUND, samples->sum + samples->count,
                                samples->value + samples->count * search->fit->row_count);
    samples->count += good ? FIT_SAMPLE_ROUND : 0;
    return good;
}

bool fit_sample_draw(FitSamples *samples, FitSearch *search) {
    size_t n = search->fit->unknown_count, rounds = 0;
    Proposal proposals[FIT_SAMPLE_ROUNDS] = {first_proposal(n)};
    *samples = (FitSamples){.at = memory_zeroed((size_t)ALL * U, sizeof(double)),
                            .sum = memory_zeroed(ALL, sizeof(double)),
                            .value = memory_zeroed(ALL * search->fit->row_count + 1, sizeof(double)),
                            .weight = memory_zeroed(ALL, sizeof(double))};
    while (rounds < FIT_SAMPLE_ROUNDS) {
        if (!draw_round(samples, search, proposals, rounds++))
            return false;
        samples->effective = weigh(samples, proposals, rounds, n, (double)n + 4);
        if (samples->effective >= FIT_SAMPLE_ENOUGH || rounds == FIT_SAMPLE_ROUNDS ||
            !next_proposal(samples, n, &proposals[rounds]))
            break;
    }
    samples->effective = weigh(samples, proposals, rounds, n, 0);
    return true;
}

/* A number with its weight. */
typedef struct Weighed {
    double at, weight;
} Weighed;

static int order_weighed(const void *a, const void *b) {
    const Weighed *x = a, *y = b;
    return x->at != y->at ? (x->at < y->at ? -1 : 1) : (x->weight > y->weight) - (x->weight < y->weight);
}

double fit_sample_quantile(const FitSamples *samples, size_t unknown, double share) {
    Weighed *list = memory_zeroed(samples->count + 1, sizeof *list);
    for (size_t s = 0; s < samples->count; s++)
        list[s] = (Weighed){samples->at[s * U + unknown], samples->weight[s]};
    qsort(list, samples->count, sizeof *list, order_weighed);
    double below = 0, at = list[0].at;
    for (size_t s = 0; s < samples->count; s++) { /* linear between the middles of the weights */
        double middle = below + list[s].weight / 2;
        double before = s ? below - list[s - 1].weight / 2 : 0;
        if (middle >= share) {
            at = s ? list[s - 1].at + (list[s].at - list[s - 1].at) * (share - before) / (middle - before) : list[s].at;
            break;
        }
        at = list[s].at;
        below += list[s].weight;
    }
    memory_free(list);
    return at;
}

size_t fit_sample_best(const FitSamples *samples) {
    size_t best = 0;
    for (size_t s = 1; s < samples->count; s++)
        best = samples->sum[s] < samples->sum[best] ? s : best;
    return best;
}

double fit_sample_left_out(const FitSamples *samples, const FitSearch *search, size_t row) {
    const Fit *fit = search->fit;
    double whole = 0, sum = 0, most = -HUGE_VAL;
    double *logs = memory_zeroed(samples->count + 1, sizeof *logs);
    for (size_t s = 0; s < samples->count; s++) {
        const double *value = samples->value + s * fit->row_count;
        logs[s] = real_log(samples->weight[s] + 1e-300);
        for (size_t r = 0; r < fit->row_count; r++)
            if (fit->rows[r].group == fit->rows[row].group)
                logs[s] += fit_search_square(search, r, value[r]) / 2;
        if (isfinite(value[row]))
            most = fmax(most, logs[s]);
    }
    for (size_t s = 0; s < samples->count; s++) {
        double value = samples->value[s * fit->row_count + row], weight = real_exp(logs[s] - most);
        if (!isfinite(value))
            continue;
        whole += weight;
        sum += weight * value;
    }
    memory_free(logs);
    return whole > 0 ? sum / whole : (double)NAN;
}

void fit_sample_clear(FitSamples *samples) {
    memory_free(samples->at);
    memory_free(samples->sum);
    memory_free(samples->value);
    memory_free(samples->weight);
    *samples = (FitSamples){0};
}
