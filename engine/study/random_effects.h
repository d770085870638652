/* One-way random effects: how far values of one group scatter, and how far groups differ, by the mean squares of an
 * analysis of variance (Searle, Casella and McCulloch 1992, section 3.6; groups may have different sizes):
 *
 *     within^2 = MSW    between^2 = max(0, (MSB - MSW) / n0)    n0 = (N - sum n_i^2 / N) / (k - 1) */
#pragma once

#include <stddef.h>

typedef struct RandomEffects {
    size_t groups;
    double within;  /* standard deviation of values of one group; NAN: no group has two values */
    double between; /* standard deviation of the groups' own means; NAN: fewer than two groups, or within is NAN */
} RandomEffects;

/* `group` holds the group of each value, from 0, less than `count`. */
RandomEffects random_effects_of(const double *values, const size_t *group, size_t count);
