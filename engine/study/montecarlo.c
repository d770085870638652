#include "study/montecarlo.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"

/* Returns a quantile of `count` sorted numbers, at least 1: the k-th of n numbers is the quantile (k - 1) / (n - 1). */
static double quantile(const double *sorted, size_t count, double share) {
    double place = share * (double)(count - 1);
    size_t below = (size_t)place;
    if (below + 1 >= count)
        return sorted[count - 1];
    return sorted[below] + (place - (double)below) * (sorted[below + 1] - sorted[below]);
}

static double deviation_of(const double *numbers, size_t count, double mean) {
    double squares = 0;
    for (size_t i = 0; i < count; i++)
        squares += (numbers[i] - mean) * (numbers[i] - mean);
    return count > 1 ? sqrt(squares / (double)(count - 1)) : (double)NAN;
}

Distribution montecarlo_distribution(const double *numbers, size_t count) {
    const double none = (double)NAN;
    Distribution d = {.mean = none, .deviation = none, .error = none, .low = none, .median = none, .high = none};
    d.least = d.greatest = d.quarters[0] = d.quarters[1] = none;
    double *finite = memory_zeroed(count, sizeof *finite), sum = 0;
    for (size_t i = 0; i < count; i++)
        if (isfinite(numbers[i]))
            sum += finite[d.count++] = numbers[i];
    if (d.count) {
        qsort(finite, d.count, sizeof *finite, order_rising);
        d.mean = sum / (double)d.count;
        d.deviation = deviation_of(finite, d.count, d.mean);
        d.error = d.deviation / sqrt((double)d.count);
        d.low = quantile(finite, d.count, 0.05);
        d.median = quantile(finite, d.count, 0.5);
        d.high = quantile(finite, d.count, 0.95);
        d.quarters[0] = quantile(finite, d.count, 0.25);
        d.quarters[1] = quantile(finite, d.count, 0.75);
        d.least = finite[0];
        d.greatest = finite[d.count - 1];
    }
    memory_free(finite);
    return d;
}

enum { SHARES = 5 };

/* Finds the quantiles of `d.count` finite numbers, as `quantile` does from sorted ones. */
static void find_quantiles(Distribution *d, const Numbers *numbers) {
    static const double shares[SHARES] = {0.05, 0.25, 0.5, 0.75, 0.95};
    double *const places[SHARES] = {&d->low, &d->quarters[0], &d->median, &d->quarters[1], &d->high};
    size_t ranks[2 * SHARES];
    double found[2 * SHARES];
    for (size_t s = 0; s < SHARES; s++) {
        ranks[2 * s] = (size_t)(shares[s] * (double)(d->count - 1));
        ranks[2 * s + 1] = ranks[2 * s] + 1 < d->count ? ranks[2 * s] + 1 : d->count - 1;
    }
    numbers_find(numbers, ranks, 2 * SHARES, found);
    for (size_t s = 0; s < SHARES; s++) {
        double part = shares[s] * (double)(d->count - 1) - (double)ranks[2 * s];
        *places[s] = found[2 * s] + part * (found[2 * s + 1] - found[2 * s]);
    }
}

/* Goes through the numbers several times. */
static Distribution streamed(const Numbers *numbers) {
    Distribution d = montecarlo_distribution(NULL, 0);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < numbers->count; i++) {
        double number = numbers_at(numbers, i);
        if (!isfinite(number))
            continue;
        d.least = d.count && d.least <= number ? d.least : number;
        d.greatest = d.count && d.greatest >= number ? d.greatest : number;
        sum += number;
        d.count++;
    }
    if (!d.count)
        return d;
    d.mean = sum / (double)d.count;
    for (size_t i = 0; i < numbers->count; i++) {
        double apart = numbers_at(numbers, i) - d.mean;
        squares += isfinite(apart) ? apart * apart : 0;
    }
    d.deviation = d.count > 1 ? sqrt(squares / (double)(d.count - 1)) : (double)NAN;
    d.error = d.deviation / sqrt((double)d.count);
    find_quantiles(&d, numbers);
    return d;
}

Distribution montecarlo_of(const Numbers *numbers) {
    if (numbers->count > MONTECARLO_SORTED)
        return streamed(numbers);
    double *held = memory_zeroed(numbers->count, sizeof *held);
    for (size_t i = 0; i < numbers->count; i++)
        held[i] = numbers_at(numbers, i);
    Distribution d = montecarlo_distribution(held, numbers->count);
    memory_free(held);
    return d;
}

/* Returns the interval of all proportions p that differ from the observed one by at most CONFIDENT sqrt(p (1 - p) /
 * n). */
Share montecarlo_share(size_t good, size_t all) {
    static const double CONFIDENT = 1.959964; /* half-width in standard deviations of 95 % of a normal distribution */
    if (!all)
        return (Share){.value = (double)NAN, .low = (double)NAN, .high = (double)NAN};
    double n = (double)all, square = CONFIDENT * CONFIDENT / n, share = (double)good / n;
    double middle = (share + square / 2) / (1 + square);
    double half = sqrt(square * (share * (1 - share) + square / 4)) / (1 + square);
    return (Share){good, all, share, good ? middle - half : 0, good < all ? middle + half : 1};
}

/* An observable of the runs of a point. */
typedef struct Runs {
    const Study *study;
    size_t pass, i1, i0, observable;
} Runs;

static double observed_at(const void *of, size_t run) {
    const Runs *runs = of;
    return study_trial(runs->study, runs->pass, run, runs->i1, runs->i0)->observed[runs->observable];
}

enum { HELD = 4 << 20 /* numbers, 32 MB */ };

/* Fills the distributions after one way through the runs, whose rows lie far apart in the memory of a large study. */
static void distribute_held(const MontecarloPoint *point, Runs runs) {
    size_t count = runs.study->runs;
    double *numbers = memory_zeroed(count * point->observables, sizeof *numbers);
    for (size_t run = 0; run < count; run++) {
        const Trial *trial = study_trial(runs.study, runs.pass, run, runs.i1, runs.i0);
        for (size_t o = 0; o < point->observables; o++)
            numbers[o * count + run] = trial->observed[o];
    }
    for (size_t o = 0; o < point->observables; o++)
        point->of[o] = montecarlo_distribution(numbers + o * count, count);
    memory_free(numbers);
}

static void distribute(const MontecarloPoint *point, Runs runs) {
    size_t count = runs.study->runs;
    if (count <= MONTECARLO_SORTED && count * point->observables <= HELD) {
        distribute_held(point, runs);
        return;
    }
    for (size_t o = 0; o < point->observables; o++) {
        runs.observable = o;
        point->of[o] = montecarlo_of(&(Numbers){observed_at, &runs, count});
    }
}

MontecarloPoint montecarlo_point(const Study *study, size_t pass, size_t i1, size_t i0) {
    const Experiment *experiment = study->experiment;
    MontecarloPoint point = {0};
    point.observables = experiment->observable_count;
    point.of = memory_zeroed(point.observables, sizeof *point.of);
    for (size_t run = 0; run < study->runs; run++) {
        const Trial *trial = study_trial(study, pass, run, i1, i0);
        double regular = trial->observed[experiment->regular];
        point.done += trial->done;
        point.faults += trial->done && trial->fault;
        point.decided += trial->done && !isnan(regular);
        point.regular += trial->done && regular == 1;
    }
    Share share = montecarlo_share(point.regular, point.decided);
    point.share = share.value;
    point.share_low = share.low;
    point.share_high = share.high;
    distribute(&point, (Runs){.study = study, .pass = pass, .i1 = i1, .i0 = i0});
    return point;
}

void montecarlo_clear(MontecarloPoint *point) {
    memory_free(point->of);
    *point = (MontecarloPoint){0};
}
