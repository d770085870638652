/* Samples the posterior density of a fit, where values change in jumps with the parameters, so that derivatives tell
 * nothing: peak forces of a motion that is periodic at one value, chaotic at the next, or jumps to another orbit.
 *
 * Adaptive importance sampling with multiple proposals [Cornuet, Marin, Mira and Robert 2012]. The first proposal is
 * the prior, widened by half, at the points of a Kronecker sequence; each later one is normal, with the mean and twice
 * the covariance of what the samples say so far, except that a tenth is drawn from the first. Samples of all rounds
 * count with the weight exp(-sum / 2) by the mixture of all proposals. While fewer than `n + 4` of them count in
 * effect, (sum w)^2 / sum w^2, the weights are flattened by a power below 1, so that a narrow peak is approached in
 * steps. */
#pragma once

#include "study/fit_search.h"

enum { FIT_SAMPLE_ROUNDS = 8 /* at most */, FIT_SAMPLE_ROUND = 48, FIT_SAMPLE_ENOUGH = 100 /* effective samples */ };

typedef struct FitSamples {
    size_t count;
    double *at;       /* (count x FIT_UNKNOWNS_MOST) */
    double *sum;      /* (count) */
    double *value;    /* (count x row_count) simulated */
    double *weight;   /* (count) which add up to 1 */
    double effective; /* samples of equal weight that would say as much */
} FitSamples;

/* Draws samples. Returns false after an interruption; fit_sample_clear releases them in either case. */
bool fit_sample_draw(FitSamples *samples, FitSearch *search);

/* Writes the mean (unknown_count) and covariance (unknown_count x unknown_count). */
void fit_sample_moments(const FitSamples *samples, size_t unknown_count, double *mean, double *covariance);

/* Returns the value of an unknown, in spreads, below which this share of the weights lies. */
double fit_sample_quantile(const FitSamples *samples, size_t unknown, double share);

/* Returns the index of the sample with the least sum. */
size_t fit_sample_best(const FitSamples *samples);

/* Predicts the value of a row by the samples as all rows but those of its group weigh them. */
double fit_sample_left_out(const FitSamples *samples, const FitSearch *search, size_t row);

void fit_sample_clear(FitSamples *samples);
