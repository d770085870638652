#include "cycle/half_life.h"

#include <math.h>

#include "base/real.h"

/* Returns the distribution function at x: 1 - exp(-x) (1 + x + x^2 / 2! + ...), `shape` terms. */
static double gamma_below(size_t shape, double x) {
    double sum = 0, term = -x, rise = real_log(x); /* logarithm of each term */
    for (size_t i = 0; i < shape; i++) {
        sum += real_exp(term);
        term += rise - real_log((double)(i + 1));
    }
    return 1 - sum;
}

double half_life_gamma(size_t shape, double probability) {
    double low = 0, high = 2 * (double)shape + 20;
    for (int i = 0; i < 80; i++) {
        double middle = low + (high - low) / 2;
        if (gamma_below(shape, middle) < probability)
            low = middle;
        else
            high = middle;
    }
    return low;
}

HalfLife half_life_tell(size_t settled, double risk) {
    double ln2 = real_log(2);
    if (!settled)
        return (HalfLife){HUGE_VAL, ln2 * risk / half_life_gamma(1, 0.95), HUGE_VAL};
    return (HalfLife){ln2 * risk / (double)settled, ln2 * risk / half_life_gamma(settled + 1, 0.975),
                      ln2 * risk / half_life_gamma(settled, 0.025)};
}

double half_life_unseen(size_t starts) {
    return starts ? 1 - real_exp(real_log(0.05) / (double)starts) : 1;
}

double half_life_starts(double share) {
    return ceil(real_log(0.05) / real_log(1 - share));
}
