/* The largest peak that is to be expected in more cycles than were run.
 *
 * Peaks above a high threshold follow, whatever the distribution of all peaks, a generalised Pareto distribution with
 * scale s and shape x: P(peak > u + y) = P(peak > u) (1 + x y / s)^(-1/x) [Pickands 1975]. Threshold: the 95th
 * percentile. s and x come from probability-weighted moments [Hosking and Wallis 1987]: with a0 the mean excess and a1
 * the mean of the excess times the share of larger ones, x = 2 - a0 / (a0 - 2 a1), s = 2 a0 a1 / (a0 - 2 a1). The
 * largest in n cycles is about the level exceeded once in n: u + s / x ((n P(peak > u))^x - 1). Peaks that follow each
 * other depend on each other, so the interval is from leaving out groups of lanes in turn (jackknife), not from the
 * number of peaks. A negative shape has an end that no peak exceeds: u - s / x. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct Extreme {
    bool known;
    double level, low, high; /* N, largest peak in so many cycles, 95 % */
    double shape;            /* 1 */
    double end;              /* N, that no peak exceeds; HUGE_VAL: none */
} Extreme;

enum { EXTREME_GROUPS = 16, EXTREME_LEAST = 100 /* peaks above the threshold, of each estimate */ };

/* `peak` holds the largest force of each cycle (0: no contact), `count` lists of `cycles` each, of which list i has
 * `used[i]` values. Unknown with fewer lists than EXTREME_GROUPS, or too few peaks. */
Extreme extreme_estimate(const double *peak, size_t count, size_t cycles, const size_t *used, double ahead);
