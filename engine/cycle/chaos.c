#include "cycle/chaos.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"
#include "base/random.h"
#include "base/real.h"

/* Exponents ------------------------------------------------------------------------------------------------------- */

static double dot(const double *a, const double *b, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

void chaos_renew_tangents(CycleMotion *motion, double *growth) {
    const CycleKind *kind = motion->cycle.kind;
    size_t states = motion->states;
    double *all = memory_zeroed(motion->tangents * states, sizeof *all);
    for (size_t t = 0; t < motion->tangents; t++) {
        double *own = all + t * states;
        kind->tangent(motion->own, t, own);
        for (int twice = 0; twice < 2; twice++)
            for (size_t s = 0; s < t; s++) {
                double along = dot(own, all + s * states, states);
                for (size_t i = 0; i < states; i++)
                    own[i] -= along * all[s * states + i];
            }
        double length = sqrt(dot(own, own, states));
        growth[t] += real_log(length);
        for (size_t i = 0; i < states; i++)
            own[i] /= length;
        kind->set_tangent(motion->own, t, own);
    }
    memory_free(all);
}

ChaosExponent chaos_exponent(const double *growth, size_t count) {
    double mean = 0, variance = 0;
    for (size_t i = 0; i < count; i++)
        mean += growth[i] / (double)count;
    size_t size = count / CHAOS_BATCHES;
    if (size == 0)
        return (ChaosExponent){mean, HUGE_VAL};
    for (size_t b = 0; b < CHAOS_BATCHES; b++) {
        double batch = 0;
        for (size_t i = b * size; i < (b + 1) * size; i++)
            batch += growth[i] / (double)size;
        variance += (batch - mean) * (batch - mean) / (CHAOS_BATCHES - 1);
    }
    return (ChaosExponent){mean, sqrt(variance / CHAOS_BATCHES)};
}

/* The 0-1 test ---------------------------------------------------------------------------------------------------- */

enum { FREQUENCIES = 100 /* values of c */ };

/* Returns the correlation of `count` values with 1, 2, 3 ... */
static double correlation_with_time(const double *values, size_t count) {
    double mean = 0, middle = ((double)count - 1) / 2, own = 0, time = 0, both = 0;
    for (size_t i = 0; i < count; i++)
        mean += values[i] / (double)count;
    for (size_t i = 0; i < count; i++) {
        double v = values[i] - mean, t = (double)i - middle;
        own += v * v;
        time += t * t;
        both += v * t;
    }
    return own > 0 ? both / sqrt(own * time) : 0;
}

/* Returns the sum of (a - b)^2 in four partial sums; nearly all the time of the 0-1 test is spent here. */
static double square_distance(const double *a, const double *b, size_t count) {
    double sum[4] = {0};
    size_t whole = count - count % 4;
    for (size_t i = 0; i < whole; i += 4)
        for (size_t k = 0; k < 4; k++)
            sum[k] += (a[i + k] - b[i + k]) * (a[i + k] - b[i + k]);
    for (size_t i = whole; i < count; i++)
        sum[0] += (a[i] - b[i]) * (a[i] - b[i]);
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

/* Returns K for one c: p and q are the sums of the series rotated by c, 2c, 3c ...; their mean square displacement
 * grows if the series is chaotic. */
static double growth_of(const double *series, size_t count, double mean, double c, double *room) {
    size_t lags = count / 10, span = count - lags;
    double *p = room, *q = room + count, *displacement = room + 2 * count, sum_p = 0, sum_q = 0;
    for (size_t i = 0; i < count; i++) {
        SineCosine turn = real_sincos((double)(i + 1) * c);
        p[i] = sum_p += series[i] * turn.cosine;
        q[i] = sum_q += series[i] * turn.sine;
    }
    for (size_t n = 1; n <= lags; n++) {
        double moved = square_distance(p + n, p, span) + square_distance(q + n, q, span);
        displacement[n - 1] = moved / (double)span - mean * mean * (1 - real_cos((double)n * c)) / (1 - real_cos(c));
    }
    return correlation_with_time(displacement, lags);
}

double chaos_zero_one(const double *series, size_t count) {
    double grown[FREQUENCIES], mean = 0, *room = memory_zeroed(3 * count, sizeof *room);
    Random random = random_seed(1, 0); /* random values of c avoid the resonances of a regular series */
    for (size_t i = 0; i < count; i++)
        mean += series[i] / (double)count;
    for (int k = 0; k < FREQUENCIES; k++) {
        double c = M_PI * (0.2 + 0.6 * random_uniform(&random));
        grown[k] = growth_of(series, count, mean, c, room);
    }
    memory_free(room);
    qsort(grown, FREQUENCIES, sizeof *grown, order_rising);
    return (grown[FREQUENCIES / 2 - 1] + grown[FREQUENCIES / 2]) / 2;
}
