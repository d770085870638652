/* The distribution of results over the seeds of one point. */
#pragma once

#include "study/numbers.h"
#include "study/study.h"

/* Statistics of the finite values; NAN where there are too few. */
typedef struct Distribution {
    size_t count;
    double mean;
    double deviation;         /* standard deviation of a run: with n - 1 */
    double error;             /* standard error of the mean: deviation / sqrt(n) */
    double low, median, high; /* quantiles of 5, 50 and 95 %, interpolated linearly */
    double quarters[2];       /* quantiles of 25 and 75 % */
    double least, greatest;
} Distribution;

/* Below this number of values a range is told from the least to the greatest, from it on from 5 to 95 %. */
enum { MONTECARLO_BAND = 40 };

typedef struct MontecarloPoint {
    size_t done;    /* runs */
    size_t faults;  /* runs that were impossible with their values */
    size_t decided; /* runs known to be regular or irregular */
    size_t regular; /* regular ones among those */
    double share;   /* 1, proportion of regular runs; NAN: none is known */
    double share_low,
        share_high;   /* 1, 95 % confidence interval of the proportion (Wilson 1927), valid also for none and for all */
    Distribution *of; /* (observables) */
    size_t observables;
} MontecarloPoint;

/* A proportion and its 95 % confidence interval (Wilson 1927); NAN where `all` is 0. */
typedef struct Share {
    size_t good, all;
    double value, low, high; /* 1 */
} Share;

Share montecarlo_share(size_t good, size_t all);

/* Computes the distribution of `count` numbers, some of which may be NAN. */
Distribution montecarlo_distribution(const double *numbers, size_t count);

/* The same of numbers that are not held. More than MONTECARLO_SORTED of them are not sorted but gone through several
 * times: then only the last bits of the mean and the deviation depend on their order. */
Distribution montecarlo_of(const Numbers *numbers);
enum { MONTECARLO_SORTED = 1 << 20 };

/* Computes the distributions of the completed runs of a point. montecarlo_clear releases the result. */
MontecarloPoint montecarlo_point(const Study *study, size_t pass, size_t i1, size_t i0);
void montecarlo_clear(MontecarloPoint *point);
