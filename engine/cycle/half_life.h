/* How long a transient lasts, from motions that were watched until they settled or the watching ended.
 *
 * Chaos that is not for ever is left at a constant rate, as a nucleus decays: while a motion wanders, each cycle has
 * the same chance that it comes near the attractor and stays. Of m motions k settled within a total of T cycles during
 * which one could (of those that did not settle: all they were watched). The rate is then k / T, the half-life ln 2 T /
 * k, and since T times the rate has a gamma distribution, an interval of 95 % follows from the quantiles of those of k
 * and k + 1 (half of chi-squared ones of 2 k and 2 k + 2 degrees). When none settled, the half-life is above ln 2 T
 * / 3.0, for a longer one's chance of none is above 5 % [Lawless 2003, section 4.1: type I censoring]. */
#pragma once

#include <stddef.h>

typedef struct HalfLife {
    double value;     /* cycles; HUGE_VAL: none settled */
    double low, high; /* cycles, 95 %; high is HUGE_VAL if none settled, and low is then one-sided */
} HalfLife;

/* `settled` motions settled in `risk` cycles of all motions together. */
HalfLife half_life_tell(size_t settled, double risk);

/* Returns the quantile of the gamma distribution of whole shape (at least 1) and scale 1. */
double half_life_gamma(size_t shape, double probability);

/* Returns the share of starts, 95 %, below which the basin of an attractor that none of `starts` random starts has
 * reached must lie; and the number of starts of which at least one reaches a basin of this share with 95 %. */
double half_life_unseen(size_t starts);
double half_life_starts(double share);
