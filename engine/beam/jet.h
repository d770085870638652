/* Taylor polynomial of an observed quantity about an instant: y(t) = sum over m of term[m] t^m, exact to rounding
 * within a part of a cell (regime.h). Its roots and extrema need no exponentials. */
#pragma once

#include <assert.h>

#include "beam/regime.h"

typedef struct Jet {
    double term[REGIME_TERMS]; /* unit of y / s^m */
} Jet;

static_assert(REGIME_TERMS == 8, "jet_value has them all");

static inline double jet_value(const Jet *jet, double time) {
    const double *term = jet->term;
    double square = time * time;
    double low = (term[0] + term[1] * time) + (term[2] + term[3] * time) * square;
    double high = (term[4] + term[5] * time) + (term[6] + term[7] * time) * square;
    return low + high * (square * square);
}

/* Returns y' multiplied by `times`. */
static inline Jet jet_rate(const Jet *jet, double times) {
    Jet rate = {{0}};
    for (int m = 1; m < REGIME_TERMS; m++)
        rate.term[m - 1] = times * m * jet->term[m];
    return rate;
}

/* Returns the time at which y, negative at `low` and not negative at `high`, rises through 0, to JET_RESOLUTION s;
 * starts at `guess`. */
double jet_rise(const Jet *jet, double low, double high, double guess);

/* s: precision of switches; rounding dominates below it. */
#define JET_RESOLUTION 1e-15
