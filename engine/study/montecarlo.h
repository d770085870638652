/* The runs of one point with many seeds, as a distribution. */
#pragma once

#include "study/study.h"

/* Of the finite numbers that the runs gave; NAN where there are too few. */
typedef struct Distribution {
    size_t count;
    double mean;
    double deviation;         /* standard, of a run: with n - 1 */
    double error;             /* standard, of the mean: deviation / sqrt(n) */
    double low, median, high; /* quantiles of 5, 50 and 95 %, between two runs in proportion */
    double quarters[2];       /* of 25 and 75 % */
    double least, greatest;
} Distribution;

typedef struct MontecarloPoint {
    size_t done;                  /* runs */
    size_t faults;                /* of them could not be run with their values */
    size_t told;                  /* of them are regular or not */
    size_t regular;               /* of those told */
    double share;                 /* 1, regular over told; NAN: none is */
    double share_low, share_high; /* 1, where it is with 95 % confidence (Wilson 1927), also for none and for all */
    Distribution *of;             /* (observables) */
    size_t observables;
} MontecarloPoint;

/* So many of so many, and between which shares it is with 95 % confidence (Wilson 1927); NAN where `all` is 0. */
typedef struct Share {
    size_t good, all;
    double value, low, high; /* 1 */
} Share;

Share montecarlo_share(size_t good, size_t all);

/* Of numbers (count), some of which may be NAN. */
Distribution montecarlo_distribution(const double *numbers, size_t count);

/* Of the runs of a point that are done. montecarlo_clear releases it. */
MontecarloPoint montecarlo_point(const Study *study, size_t pass, size_t i1, size_t i0);
void montecarlo_clear(MontecarloPoint *point);
