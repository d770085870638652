/* Fits parameters of any experiment to measurements: see fit.c. It knows neither houses nor beams. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "study/experiment.h"

enum { FIT_UNKNOWNS_MOST = 8, FIT_STARTS = 5 };

#define FIT_LEARNED_LEAST 0.3 /* 1, below which the data do not tell a parameter */

/* A parameter to be fitted, always positive: its logarithm is unknown, normally distributed about that of the prior. */
typedef struct FitUnknown {
    const char *name; /* of a parameter of the experiments */
    double prior;     /* in the unit of the parameter */
    double spread;    /* 1, standard deviation of the logarithm before the data */

    double best;        /* most probable value */
    double value;       /* to be used: best, or the prior where the data do not tell */
    double deviation;   /* 1, standard deviation of the logarithm after the data */
    double low, high;   /* 90 % interval */
    double least, most; /* 95 % interval */
    double learned;     /* 1 - (deviation / spread)^2 */
    bool told;          /* True if learned is at least FIT_LEARNED_LEAST */
    bool skew; /* True if the profile differs from the straight interval by more than 30 %, so that it counts */
} FitUnknown;

/* A measured value. */
typedef struct FitRow {
    const Experiment *experiment;
    size_t observable;
    size_t way;               /* observable whose value must stay the same for derivatives; SIZE_MAX: none */
    const char *const *names; /* (name_count) parameters set for this row alone, the same array for all rows of an */
    const double *at;         /* experiment; and their values */
    size_t name_count;
    double observed;
    double deviation; /* standard deviation, in the unit of the observable; of the logarithm where `relative` */
    bool relative;    /* True if the residual is that of the logarithm */
    size_t group;     /* rows of one group are left out together */
    const char *label;

    double before;    /* simulated with the priors; NAN: no value */
    double simulated; /* with the best values */
    double residual;  /* 1, (simulated - observed) / deviation */
    double left_out;  /* simulated with values fitted to the other groups; NAN: not tried */
} FitRow;

typedef struct Fit {
    FitUnknown *unknowns; /* (unknown_count) at most FIT_UNKNOWNS_MOST */
    size_t unknown_count;
    FitRow *rows; /* (row_count) */
    size_t row_count;
    bool robust;    /* True if outliers count less: Student's t with 4 degrees of freedom */
    bool jumps;     /* True if values change in jumps with the unknowns: intervals come from samples (fit_sample.h) */
    bool leave_out; /* True if each group is predicted from the others */
    size_t starts;  /* at most FIT_STARTS; 0: FIT_STARTS */
    int jobs;
    const Stop *stop;
    void (*progress)(void *context, size_t runs); /* NULL: none */
    void *context;

    double sum, sum_before;             /* of squared residuals, with the priors' own; after and before */
    double singular[FIT_UNKNOWNS_MOST]; /* of the data's derivatives by spreads: how many numbers the data tell */
    double correlation[FIT_UNKNOWNS_MOST * FIT_UNKNOWNS_MOST]; /* (unknowns x unknowns) after the data */
    size_t basins;              /* separate minima whose sums are within 2 of the least one; with `jumps` 0: unknown */
    double effective;           /* with `jumps`: samples of equal weight that would say as much as those drawn */
    size_t runs;                /* simulations */
    double sign_runs;           /* 1, deviation of the number of runs of equal signs from chance; NAN: too few rows */
    double error, error_before; /* root mean square residual of groups that are left out, and with the priors */
    bool interrupted;
} Fit;

/* Fits. Returns false after an error, when nothing can be simulated with the priors. The result does not depend on the
 * number of jobs. */
bool fit_run(Fit *fit, Fault *fault);

/* Returns the correlation of two unknowns after the data. */
static inline double fit_correlation(const Fit *fit, size_t i, size_t j) {
    return fit->correlation[i * fit->unknown_count + j];
}
