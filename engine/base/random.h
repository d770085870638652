/* A seeded random generator: the same seed gives the same numbers on every machine.
 * xoshiro256** of Blackman and Vigna (2018), seeded by splitmix64 (Steele, Lea and Flood 2014). */
#pragma once

#include <stdint.h>

typedef struct Random {
    uint64_t state[4];
} Random;

/* Returns a generator for one purpose: different streams of one seed do not overlap in practice. */
Random random_seed(uint64_t seed, uint64_t stream);

uint64_t random_bits(Random *random);

/* Returns a number uniform in [0, 1). */
double random_uniform(Random *random);

/* Returns a normally distributed number with the given mean and standard deviation (polar method of Marsaglia). */
double random_normal(Random *random, double mean, double deviation);
