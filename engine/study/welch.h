/* Compares a measured mean with a simulated one, by Welch (1947): SE^2 = b^2 / n + d^2 / N, with the degrees of freedom
 * of Satterthwaite (1946). Two means agree within a share of the measured one if the 90 % interval of their difference
 * lies within it (two one-sided tests, Schuirmann 1987); they differ if the 95 % interval does not contain 0. */
#pragma once

#include <stddef.h>

typedef struct WelchSample {
    double mean, deviation; /* with n - 1 */
    size_t count;
} WelchSample;

typedef enum WelchVerdict {
    WELCH_AGREES,
    WELCH_DIFFERS,
    WELCH_CANNOT_TELL,
    WELCH_TOO_FEW, /* fewer than two runs on a side, or no deviation on both: there is no interval */
} WelchVerdict;

typedef struct Welch {
    int verdict;       /* WelchVerdict */
    double difference; /* simulated - measured */
    double low, high;  /* its 95 % interval; NAN with WELCH_TOO_FEW, as the next two */
    double degrees, t; /* of freedom; difference / SE */
} Welch;

/* `within`: share of the measured mean, 0.1 for 10 %. */
Welch welch_compare(const WelchSample *measured, const WelchSample *simulated, double within);

/* Returns the quantile of Student's distribution, 0 < p < 1, with `degrees` > 0 of freedom, to 1e-8. */
double welch_student(double p, double degrees);

/* Returns the quantile of Fisher's distribution of the ratio of two variances, 0 < p < 1, with `above` > 0 degrees of
 * freedom of the one above the line and `below` > 0 of the one below it, to 1e-8. */
double welch_fisher(double p, double above, double below);

/* How widely simulated values scatter beside measured ones. */
typedef struct WelchScatter {
    double ratio;     /* 1, of the deviations, simulated / measured; NAN: fewer than two on a side, or one is 0 */
    double low, high; /* its 95 % interval; NAN with it */
} WelchScatter;

WelchScatter welch_scatter(const WelchSample *measured, const WelchSample *simulated);
