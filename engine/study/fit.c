/* The most probable parameters p of an experiment after measurements, by non-linear least squares.
 *
 * The unknowns are u = ln p / p0 in units of their spread s, so that the prior is N(0, 1) for each. The residuals are
 * (simulated - observed) / deviation, or of logarithms, for each row, and u itself for each prior; half the sum of
 * their squares is minus the logarithm of the posterior density. With `robust` a residual r counts as
 * sign(r) sqrt((n + 1) ln(1 + r^2 / n)), n = 4, which makes the sum that of Student's t.
 *
 * Levenberg-Marquardt (Levenberg 1944, Marquardt 1963): (J^T J + mu I) step = -J^T r, mu divided by 10 after a step
 * that lowers the sum, else multiplied by 10. J is brought up to date by Broyden's rule after a step, and computed
 * again after one that failed. It is of differences to both sides; where the experiment takes another way on one side
 * (FitRow.way), only the other side counts. A way that flips leaves a step in the sum: where no step lowers it, the
 * simplex of Nelder and Mead (1965) goes on from there.
 *
 * The starts are points of the Kronecker sequence with the root of g^(d+1) = g + 1, as quantiles within +-1.3 spreads.
 *
 * Interval: (J^T J)^-1 at the least sum, then the profile: each unknown fixed at +-2 standard deviations, the others
 * fitted. The sum then rises by 4 where it is quadratic; where the standard deviation of either side that follows from
 * its rise differs by more than 30 %, that of the profile counts, for its side. Where values change in jumps, neither
 * tells anything, and samples of the posterior take their place: see fit_sample.h. */
#include "study/fit.h"

#include <lapacke.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "study/fit_sample.h"
#include "study/fit_search.h"

static const double START_REACH = 1.3; /* spreads within which searches start */
static const double NINETY = 1.6448536269514722, NINETY_FIVE = 1.959963984540054; /* standard deviations */
static const double SAME_SUM = 2;     /* difference of sums of two minima that are both possible */
static const double SAME_PLACE = 0.5; /* spreads between two minima that are one */

static const double LOWER = 0.01; /* 1, of 1 + the sum: a profile that falls by more has found a better place */

enum { U = FIT_UNKNOWNS_MOST, SETTLINGS = 4 };

/* Starts, intervals and checks --------------------------------------------------------------------------------------
 */

static void start_at(const Fit *fit, size_t start, double *u) {
    double place[U];
    fit_search_kronecker(fit->unknown_count, start, place);
    for (size_t i = 0; i < fit->unknown_count; i++)
        u[i] = start ? START_REACH * (2 * place[i] - 1) : 0;
}

static bool search_all(FitSearch *search, double *best, double *least) {
    Fit *fit = search->fit;
    double found[FIT_STARTS][U], sums[FIT_STARTS];
    size_t starts = fit->starts && fit->starts < FIT_STARTS ? fit->starts : FIT_STARTS, first = 0;
    for (size_t s = 0; s < starts; s++) {
        start_at(fit, s, found[s]);
        bool good = fit_search_from(search, found[s], &sums[s]);
        search->derivatives = search->kept; /* those of one start will do to begin with at the next */
        if (!good)
            return false;
        first = sums[s] < sums[first] ? s : first;
    }
    memcpy(best, found[first], sizeof found[first]);
    *least = sums[first];
    for (size_t s = 0; s < starts; s++) {
        bool apart = sums[s] < *least + SAME_SUM;
        for (size_t k = 0; k < s && apart; k++) {
            double distance = 0;
            for (size_t i = 0; i < fit->unknown_count; i++)
                distance = fmax(distance, fabs(found[s][i] - found[k][i]));
            apart = !(sums[k] < *least + SAME_SUM && distance < SAME_PLACE);
        }
        fit->basins += apart;
    }
    return fit_search_evaluate(search, best, least);
}

/* Returns the standard deviation, in spreads, that follows from the rise of the profile `by` away from the best u; and
 * leaves u and the sum of the profile. */
static bool profile_at(FitSearch *search, const double *best, double least, size_t unknown, double by,
                       double *deviation, double *u, double *found) {
    double sum;
    memcpy(u, best, U * sizeof *u);
    u[unknown] += by;
    search->fixed = unknown;
    bool good = fit_search_from(search, u, &sum);
    search->fixed = SIZE_MAX;
    *deviation = sum > least ? fabs(by) / sqrt(sum - least) : HUGE_VAL;
    *found = sum;
    return good;
}

/* Finds the intervals around the best u. Where a profile finds a sum that is lower still by LOWER, `better`, unless it
 * is NULL, becomes that place, `moved` true, and the intervals mean nothing. */
static bool find_intervals(FitSearch *search, const double *best, double least, double *kept, double *better,
                           bool *moved) {
    Fit *fit = search->fit;
    size_t n = fit->unknown_count;
    double *jacobian = memory_zeroed(fit->row_count * n + 1, sizeof *jacobian), normal[U * U], slope[U], none[U];
    bool good = fit_search_derive(search, best, jacobian);
    memcpy(kept, jacobian, fit->row_count * n * sizeof *kept);
    fit_search_form_normal(search, best, jacobian, normal, slope);
    lapack_int order = (lapack_int)n, rows = (lapack_int)fit->row_count;
    good = good && LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', order, normal, order) == 0 &&
           LAPACKE_dpotri(LAPACK_COL_MAJOR, 'U', order, normal, order) == 0;
    good = good && LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'N', 'N', rows, order, jacobian, rows, fit->singular, NULL, 1, NULL,
                                  1, none) == 0;
    memory_free(jacobian);
    for (size_t i = 0; i < n && good; i++)
        for (size_t j = 0; j < n; j++) {
            double covariance = i < j ? normal[j * n + i] : normal[i * n + j];
            fit->correlation[i * n + j] = covariance / sqrt(normal[i * n + i] * normal[j * n + j]);
        }
    search->derivatives = kept;
    for (size_t i = 0; i < n && good; i++) {
        FitUnknown *unknown = &fit->unknowns[i];
        double straight = sqrt(normal[i * n + i]), sides[2], u[U], sum = least;
        unknown->skew = false;
        for (int side = 0; side < 2 && good; side++) {
            good = profile_at(search, best, least, i, (side ? 2 : -2) * straight, &sides[side], u, &sum);
            if (good && better && sum < least - LOWER * (1 + least)) {
                memcpy(better, u, sizeof u);
                *moved = true;
                return true;
            }
            bool differs = fabs(sides[side] / straight - 1) > 0.3;
            sides[side] = differs ? fmin(sides[side], 1.0) : straight; /* never wider than the prior */
            unknown->skew |= differs;
        }
        double deviation = sqrt((sides[0] * sides[0] + sides[1] * sides[1]) / 2);
        unknown->deviation = deviation * unknown->spread;
        unknown->learned = 1 - deviation * deviation;
        unknown->told = unknown->learned >= FIT_LEARNED_LEAST;
        unknown->best = fit_search_value(unknown, best[i]);
        unknown->value = unknown->told ? unknown->best : unknown->prior;
        unknown->low = fit_search_value(unknown, best[i] - NINETY * sides[0]);
        unknown->high = fit_search_value(unknown, best[i] + NINETY * sides[1]);
        unknown->least = fit_search_value(unknown, best[i] - NINETY_FIVE * sides[0]);
        unknown->most = fit_search_value(unknown, best[i] + NINETY_FIVE * sides[1]);
    }
    return good;
}

/* Adds what a group that was left out was predicted as. */
static void count_left_out(Fit *fit, FitRow *row, double predicted) {
    row->left_out = predicted;
    double now = fit_search_residual(row, row->left_out), before = fit_search_residual(row, row->before);
    fit->error += now * now;
    fit->error_before += before * before;
}

/* Predicts each group with what the others tell. */
static bool leave_out(FitSearch *search, const double *best) {
    Fit *fit = search->fit;
    size_t groups = 0;
    for (size_t r = 0; r < fit->row_count; r++)
        groups = fit->rows[r].group >= groups ? fit->rows[r].group + 1 : groups;
    for (size_t g = 0; g < groups; g++) {
        double u[U], sum;
        memcpy(u, best, sizeof u);
        search->without = g;
        bool good = fit_search_from(search, u, &sum);
        search->without = SIZE_MAX;
        if (!good)
            return false;
        for (size_t r = 0; r < fit->row_count; r++) {
            FitRow *row = &fit->rows[r];
            if (row->group != g)
                continue;
            count_left_out(fit, row, search->values[r]);
        }
    }
    return true;
}

/* Takes from samples what the unknowns are, how far they are known, and how they depend on one another. */
static void tell_samples(Fit *fit, const FitSamples *samples, const double *best) {
    size_t n = fit->unknown_count;
    double mean[U], covariance[U * U], values[U];
    fit_sample_moments(samples, n, mean, covariance);
    fit->effective = samples->effective;
    for (size_t i = 0; i < n; i++) {
        FitUnknown *unknown = &fit->unknowns[i];
        double deviation = sqrt(covariance[i * n + i]);
        for (size_t j = 0; j < n; j++)
            fit->correlation[i * n + j] =
                i == j ? 1 : covariance[i * n + j] / (deviation * sqrt(covariance[j * n + j]));
        unknown->deviation = deviation * unknown->spread;
        unknown->learned = 1 - deviation * deviation;
        unknown->told = unknown->learned >= FIT_LEARNED_LEAST;
        unknown->best = fit_search_value(unknown, best[i]);
        unknown->value = unknown->told ? unknown->best : unknown->prior;
        unknown->low = fit_search_value(unknown, fit_sample_quantile(samples, i, 0.05));
        unknown->high = fit_search_value(unknown, fit_sample_quantile(samples, i, 0.95));
        unknown->least = fit_search_value(unknown, fit_sample_quantile(samples, i, 0.025));
        unknown->most = fit_search_value(unknown, fit_sample_quantile(samples, i, 0.975));
    }
    /* the data add s^2 to the priors' precision, which is 1 */
    if (LAPACKE_dsyev(LAPACK_COL_MAJOR, 'N', 'U', (lapack_int)n, covariance, (lapack_int)n, values) == 0)
        for (size_t i = 0; i < n; i++)
            fit->singular[i] = sqrt(fmax(0, 1 / fmax(values[i], 1e-300) - 1));
}

/* Looks for the best values from the best sample on, and takes the intervals from the samples. */
static bool fit_by_samples(FitSearch *search, double *best, double *least) {
    Fit *fit = search->fit;
    FitSamples samples;
    bool good = fit_sample_draw(&samples, search);
    if (good) {
        memcpy(best, samples.at + fit_sample_best(&samples) * U, U * sizeof *best);
        good = fit_search_from(search, best, least);
    }
    if (good)
        tell_samples(fit, &samples, best);
    for (size_t r = 0; r < fit->row_count && good && fit->leave_out; r++)
        count_left_out(fit, &fit->rows[r], fit_sample_left_out(&samples, search, r));
    fit_sample_clear(&samples);
    return good;
}

/* The runs test of Wald and Wolfowitz on the signs of the residuals, in the order of the rows. */
static double sign_runs(const Fit *fit) {
    double above = 0, below = 0, runs = 0;
    int last = 0;
    for (size_t r = 0; r < fit->row_count; r++) {
        int sign = fit->rows[r].residual > 0 ? 1 : -1;
        above += sign > 0;
        below += sign < 0;
        runs += sign != last;
        last = sign;
    }
    double all = above + below, expected = 2 * above * below / all + 1;
    double variance = 2 * above * below * (2 * above * below - all) / (all * all * (all - 1));
    return all >= 8 && variance > 0 ? (runs - expected) / sqrt(variance) : (double)NAN;
}

/* Takes the values at the best u, which are those of the search. */
static void take_best(const FitSearch *search, double least) {
    Fit *fit = search->fit;
    fit->sum = least;
    for (size_t r = 0; r < fit->row_count; r++) {
        fit->rows[r].simulated = search->values[r];
        fit->rows[r].residual = fit_search_residual(&fit->rows[r], search->values[r]);
    }
    fit->sign_runs = sign_runs(fit);
}

/* Finds the intervals, from a better place on where a profile finds one. */
static bool settle(FitSearch *search, double *best, double least, double *kept) {
    for (int k = 0; k < SETTLINGS; k++) {
        bool moved = false;
        double better[U];
        if (!find_intervals(search, best, least, kept, better, &moved))
            return false;
        if (!moved)
            return true;
        memcpy(best, better, sizeof better);
        search->derivatives = NULL; /* those of the other place have led astray */
        if (!fit_search_from(search, best, &least))
            return false;
        take_best(search, least);
    }
    return find_intervals(search, best, least, kept, NULL, NULL);
}

static bool check(const Fit *fit, const double *values, Fault *fault) {
    for (size_t r = 0; r < fit->row_count; r++)
        if (isfinite(values[r]))
            return true;
    fault_add(fault, "nothing can be fitted: no run with the values before the fit has a result to compare");
    return false;
}

static bool fit_with(FitSearch *search, Fault *fault) {
    Fit *fit = search->fit;
    double best[U] = {0}, least;
    if (!fit_search_evaluate(search, best, &fit->sum_before))
        return true;
    for (size_t r = 0; r < fit->row_count; r++)
        fit->rows[r].before = search->values[r];
    if (!check(fit, search->values, fault))
        return false;
    double *kept = memory_zeroed(fit->row_count * fit->unknown_count + 1, sizeof *kept);
    search->kept = kept;
    bool found = fit->jumps ? fit_by_samples(search, best, &least) : search_all(search, best, &least);
    search->kept = NULL;
    search->derivatives = NULL;
    if (!found) {
        memory_free(kept);
        return true;
    }
    take_best(search, least);
    if (!fit->jumps && settle(search, best, least, kept) && fit->leave_out)
        leave_out(search, best);
    fit->error = sqrt(fit->error / (double)fit->row_count);
    fit->error_before = sqrt(fit->error_before / (double)fit->row_count);
    memory_free(kept);
    return true;
}

bool fit_run(Fit *fit, Fault *fault) {
    FitSearch search;
    for (size_t r = 0; r < fit->row_count; r++)
        fit->rows[r].before = fit->rows[r].simulated = fit->rows[r].residual = fit->rows[r].left_out = NAN;
    fit->sum = fit->sum_before = fit->sign_runs = NAN;
    fit->error = fit->error_before = 0;
    fit_search_begin(&search, fit);
    bool good = fit_with(&search, fault);
    fit_search_end(&search);
    return good;
}
