#include "cycle/extreme.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"
#include "base/real.h"

static const double QUANTILE = 0.95;
static const double STUDENT = 2.131; /* 97.5 % of 15 degrees */

typedef struct Fit {
    bool known;
    double threshold, scale, shape, rate;
} Fit;

/* Fits to sorted values. */
static Fit fit_to(const double *sorted, size_t count) {
    size_t first = (size_t)(QUANTILE * (double)count), over = count - first;
    if (over < EXTREME_LEAST)
        return (Fit){.known = false};
    double a0 = 0, a1 = 0, threshold = sorted[first - 1];
    for (size_t i = first; i < count; i++) {
        double excess = sorted[i] - threshold, larger = ((double)(count - 1 - i) + 0.35) / (double)over;
        a0 += excess / (double)over;
        a1 += excess * larger / (double)over;
    }
    double apart = a0 - 2 * a1;
    return (Fit){.known = apart > 0 && a0 > 0,
                 .threshold = threshold,
                 .shape = 2 - a0 / apart,
                 .scale = 2 * a0 * a1 / apart,
                 .rate = (double)over / (double)count};
}

static double level_of(const Fit *fit, double ahead) {
    double logarithm = real_log(ahead * fit->rate), x = fit->shape;
    return fit->threshold + fit->scale * (fabs(x) < 1e-6 ? logarithm : (real_exp(x * logarithm) - 1) / x);
}

/* Fits to all lists but those of a group (EXTREME_GROUPS: all). */
static Fit fit_without(const double *peak, size_t count, size_t cycles, const size_t *used, size_t group,
                       double *room) {
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; i % EXTREME_GROUPS != group && c < used[i]; c++)
            room[kept++] = peak[i * cycles + c];
    qsort(room, kept, sizeof *room, order_rising);
    return kept ? fit_to(room, kept) : (Fit){.known = false};
}

Extreme extreme_estimate(const double *peak, size_t count, size_t cycles, const size_t *used, double ahead) {
    if (count < EXTREME_GROUPS)
        return (Extreme){.known = false};
    double *room = memory_zeroed(count * cycles, sizeof *room), level[EXTREME_GROUPS], mean = 0, spread = 0;
    Fit all = fit_without(peak, count, cycles, used, EXTREME_GROUPS, room);
    bool known = all.known;
    for (size_t g = 0; g < EXTREME_GROUPS && known; g++) {
        Fit fit = fit_without(peak, count, cycles, used, g, room);
        known = fit.known;
        level[g] = known ? level_of(&fit, ahead) : 0;
        mean += level[g] / EXTREME_GROUPS;
    }
    memory_free(room);
    if (!known)
        return (Extreme){.known = false};
    for (size_t g = 0; g < EXTREME_GROUPS; g++)
        spread += (level[g] - mean) * (level[g] - mean) * (EXTREME_GROUPS - 1) / EXTREME_GROUPS;
    double value = level_of(&all, ahead), half = STUDENT * sqrt(spread);
    return (Extreme){true,         value,     value - half,
                     value + half, all.shape, all.shape < 0 ? all.threshold - all.scale / all.shape : HUGE_VAL};
}
