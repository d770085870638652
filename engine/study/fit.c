/* The most probable parameters p of an experiment after measurements, by non-linear least squares.
 *
 * The unknowns are u = ln p / p0 in units of their spread s, so that the prior is N(0, 1) for each. The residuals are
 * (simulated - observed) / deviation, or of logarithms, for each row, and u itself for each prior; half the sum of
 * their squares is minus the logarithm of the posterior density. With `robust` a residual r counts as
 * sign(r) sqrt((n + 1) ln(1 + r^2 / n)), n = 4, which makes the sum that of Student's t.
 *
 * Levenberg-Marquardt (Levenberg 1944, Marquardt 1963): (J^T J + mu I) step = -J^T r, mu divided by 10 after a step
 * that lowers the sum, else multiplied by 10. J is of differences to both sides; where the experiment takes another way
 * on one side (FitRow.way), only the other side counts. A way that flips leaves a step in the sum: where no step
 * lowers it, the simplex of Nelder and Mead (1965) goes on from there.
 *
 * The starts are points of the Kronecker sequence with the root of g^(d+1) = g + 1, as quantiles within +-1.3 spreads.
 *
 * Interval: (J^T J)^-1 at the least sum, then the profile: each unknown fixed at +-2 standard deviations, the others
 * fitted. The sum then rises by 4 where it is quadratic; where the standard deviation of either side that follows from
 * its rise differs by more than 30 %, that of the profile counts, for its side. */
#include "study/fit.h"

#include <lapacke.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/parallel.h"
#include "base/real.h"
#include "base/text.h"

static const double STUDENT = 4;                 /* degrees of freedom */
static const double NO_VALUE = 10;               /* 1, residual of a run without a value */
static const double DIFFERENCE = 0.02;           /* of a logarithm, to both sides */
static const double FARTHEST = 4;                /* spreads from the prior that are looked at */
static const double START_REACH = 1.3;           /* spreads within which searches start */
static const double NINETY = 1.6448536269514722; /* standard deviations */
static const double SAME_SUM = 2;                /* difference of sums of two minima that are both possible */
static const double SAME_PLACE = 0.5;            /* spreads between two minima that are one */
static const double SETTLED = 1e-4;              /* of the sum: numerics, when a search has ended */

enum { STEPS_MOST = 25, REFUSED_MOST = 3, SIMPLEX_STEPS = 120, U = FIT_UNKNOWNS_MOST };

/* A search: the fit, with which rows and unknowns. */
typedef struct Search {
    Fit *fit;
    size_t *first;  /* (row_count) row whose run this row shares */
    size_t without; /* group that is left out; SIZE_MAX: none */
    size_t fixed;   /* unknown that is held; SIZE_MAX: none */
    double *values; /* (row_count) simulated */
    double *ways;   /* (row_count) */
} Search;

/* Simulations -------------------------------------------------------------------------------------------------------
 */

static bool is_same_run(const FitRow *a, const FitRow *b) {
    if (a->experiment != b->experiment || a->name_count != b->name_count)
        return false;
    for (size_t i = 0; i < a->name_count; i++)
        if (a->at[i] != b->at[i])
            return false;
    return true;
}

static size_t *share_runs(const Fit *fit) {
    size_t *first = memory_zeroed(fit->row_count + 1, sizeof *first);
    for (size_t r = 0; r < fit->row_count; r++)
        while (!is_same_run(&fit->rows[first[r]], &fit->rows[r]))
            first[r]++;
    return first;
}

static double value_of(const FitUnknown *unknown, double u) {
    return unknown->prior * real_exp(u * unknown->spread);
}

/* Points at which all rows are simulated. */
typedef struct Sites {
    const Search *search;
    const double *at; /* (count x U) */
    size_t count;
    size_t *pieces; /* (piece_count) point * row_count + row of the first run in it */
    size_t piece_count;
    double *values, *ways; /* (count x row_count) */
    bool interrupted;
} Sites;

static bool belongs(const Sites *sites, size_t begin, size_t row) {
    const Fit *fit = sites->search->fit;
    return sites->search->first[row] == row && fit->rows[row].experiment == fit->rows[begin].experiment;
}

/* Runs the rows of one experiment at one point, from the first row on as many as it runs best together. */
static void run_piece(void *context, size_t piece) {
    Sites *sites = context;
    const Fit *fit = sites->search->fit;
    size_t point = sites->pieces[piece] / fit->row_count, begin = sites->pieces[piece] % fit->row_count;
    const FitRow *row = &fit->rows[begin];
    const Experiment *experiment = row->experiment;
    size_t names = row->name_count + fit->unknown_count, batch = experiment->batch ? experiment->batch : 1, count = 0;
    const char **name = memory_zeroed(names, sizeof *name);
    double *at = memory_zeroed(batch * names, sizeof *at);
    double *observed = memory_zeroed(batch * experiment->observable_count, sizeof *observed);
    Trial *trials = memory_zeroed(batch, sizeof *trials);
    size_t *rows = memory_zeroed(batch, sizeof *rows);
    if (row->name_count)
        memcpy(name, row->names, row->name_count * sizeof *name);
    for (size_t i = 0; i < fit->unknown_count; i++)
        name[row->name_count + i] = fit->unknowns[i].name;
    for (size_t r = begin; r < fit->row_count && count < batch; r++) {
        if (!belongs(sites, begin, r))
            continue;
        double *own = at + count * names;
        if (row->name_count)
            memcpy(own, fit->rows[r].at, row->name_count * sizeof *own);
        for (size_t i = 0; i < fit->unknown_count; i++)
            own[row->name_count + i] = value_of(&fit->unknowns[i], sites->at[point * U + i]);
        trials[count] = (Trial){.at = own, .observed = observed + count * experiment->observable_count};
        rows[count++] = r;
    }
    experiment->run(experiment->given, name, names, trials, count, false, fit->stop);
    for (size_t t = 0; t < count; t++) {
        for (size_t r = 0; r < fit->row_count; r++) {
            const FitRow *one = &fit->rows[r];
            bool good = trials[t].done && !trials[t].fault;
            if (sites->search->first[r] != rows[t])
                continue;
            sites->values[point * fit->row_count + r] = good ? trials[t].observed[one->observable] : (double)NAN;
            sites->ways[point * fit->row_count + r] = good && one->way != SIZE_MAX ? trials[t].observed[one->way] : 0;
        }
        trial_clear(&trials[t]);
    }
    memory_free(rows);
    memory_free(trials);
    memory_free(observed);
    memory_free(at);
    memory_free(name);
}

/* Simulates all rows at `count` points (count x U), on several threads. Returns false after an interruption. */
static bool simulate(Search *search, const double *at, size_t count, double *values, double *ways) {
    Fit *fit = search->fit;
    Sites sites = {.search = search, .at = at, .count = count, .values = values, .ways = ways};
    sites.pieces = memory_zeroed(count * fit->row_count + 1, sizeof *sites.pieces);
    for (size_t p = 0; p < count; p++)
        for (size_t r = 0; r < fit->row_count; r++) {
            const Experiment *experiment = fit->rows[r].experiment;
            if (search->first[r] != r)
                continue;
            fit->runs++;
            size_t before = 0; /* runs of the same experiment before this one */
            for (size_t k = 0; k < r; k++)
                before += search->first[k] == k && fit->rows[k].experiment == experiment;
            if (before % (experiment->batch ? experiment->batch : 1) == 0)
                sites.pieces[sites.piece_count++] = p * fit->row_count + r;
        }
    parallel_for(fit->jobs > 0 ? fit->jobs : 1, sites.piece_count, run_piece, &sites);
    memory_free(sites.pieces);
    fit->interrupted |= stop_requested(fit->stop);
    if (fit->progress)
        fit->progress(fit->context, fit->runs);
    return !fit->interrupted;
}

/* Residuals ---------------------------------------------------------------------------------------------------------
 */

static double plain_residual(const FitRow *row, double value) {
    if (!isfinite(value) || (row->relative && !(value > 0)))
        return NO_VALUE;
    double off = row->relative ? real_log(value / row->observed) : value - row->observed;
    return off / row->deviation;
}

static double residual_of(const Search *search, size_t row, double value) {
    if (search->fit->rows[row].group == search->without)
        return 0;
    double r = plain_residual(&search->fit->rows[row], value);
    if (!search->fit->robust)
        return r;
    double size = sqrt((STUDENT + 1) * real_log1p(r * r / STUDENT));
    return r < 0 ? -size : size;
}

/* Returns the sum of squares of the rows and of the priors. */
static double sum_of(const Search *search, const double *u, const double *values) {
    double sum = 0;
    for (size_t r = 0; r < search->fit->row_count; r++) {
        double residual = residual_of(search, r, values[r]);
        sum += residual * residual;
    }
    for (size_t i = 0; i < search->fit->unknown_count; i++)
        sum += u[i] * u[i];
    return sum;
}

static bool evaluate(Search *search, const double *u, double *sum) {
    if (!simulate(search, u, 1, search->values, search->ways))
        return false;
    *sum = sum_of(search, u, search->values);
    return true;
}

/* Fills in the derivatives (row_count x unknown_count, column by column) at u, where search->values are known. */
static bool derive(Search *search, const double *u, double *jacobian) {
    Fit *fit = search->fit;
    size_t n = fit->unknown_count, rows = fit->row_count;
    double *at = memory_zeroed(2 * n * U, sizeof *at);
    double *values = memory_zeroed(2 * n * rows, sizeof *values), *ways = memory_zeroed(2 * n * rows, sizeof *ways);
    for (size_t k = 0; k < 2 * n; k++) {
        memcpy(at + k * U, u, n * sizeof *u);
        at[k * U + k / 2] += (k % 2 ? -1 : 1) * DIFFERENCE / fit->unknowns[k / 2].spread;
    }
    bool good = simulate(search, at, 2 * n, values, ways);
    for (size_t i = 0; i < n && good; i++)
        for (size_t r = 0; r < rows; r++) {
            double step = DIFFERENCE / fit->unknowns[i].spread, middle = residual_of(search, r, search->values[r]);
            bool up = ways[2 * i * rows + r] == search->ways[r], down = ways[(2 * i + 1) * rows + r] == search->ways[r];
            double high = residual_of(search, r, values[2 * i * rows + r]);
            double low = residual_of(search, r, values[(2 * i + 1) * rows + r]);
            jacobian[i * rows + r] = up && down ? (high - low) / (2 * step)
                                     : up       ? (high - middle) / step
                                     : down     ? (middle - low) / step
                                                : 0;
        }
    memory_free(at);
    memory_free(values);
    memory_free(ways);
    return good;
}

/* Forms J^T J with the priors' rows, and J^T r. */
static void form_normal(const Search *search, const double *u, const double *jacobian, double *normal, double *slope) {
    size_t n = search->fit->unknown_count, rows = search->fit->row_count;
    for (size_t i = 0; i < n; i++) {
        slope[i] = u[i];
        for (size_t r = 0; r < rows; r++)
            slope[i] += jacobian[i * rows + r] * residual_of(search, r, search->values[r]);
        for (size_t j = 0; j < n; j++) {
            normal[i * n + j] = i == j;
            for (size_t r = 0; r < rows; r++)
                normal[i * n + j] += jacobian[i * rows + r] * jacobian[j * rows + r];
        }
    }
    for (size_t i = 0; i < n && search->fixed != SIZE_MAX; i++) {
        normal[search->fixed * n + i] = normal[i * n + search->fixed] = i == search->fixed;
        slope[search->fixed] = 0;
    }
}

/* Searches ----------------------------------------------------------------------------------------------------------
 */

/* Solves for a step with damping mu; false: the matrix is not positive. */
static bool solve_step(const double *normal, const double *slope, size_t n, double mu, double *step) {
    double matrix[U * U];
    memcpy(matrix, normal, n * n * sizeof *matrix);
    for (size_t i = 0; i < n; i++) {
        matrix[i * n + i] += mu;
        step[i] = -slope[i];
    }
    return LAPACKE_dposv(LAPACK_COL_MAJOR, 'U', (lapack_int)n, 1, matrix, (lapack_int)n, step, (lapack_int)n) == 0;
}

static bool is_near_prior(const double *u, size_t n) {
    for (size_t i = 0; i < n; i++)
        if (!(fabs(u[i]) <= FARTHEST))
            return false;
    return true;
}

/* Orders the corners of a simplex by their sums, the least first. */
static void order_simplex(double corners[U + 1][U], double sums[U + 1], size_t n) {
    for (size_t i = 1; i <= n; i++)
        for (size_t k = i; k > 0 && sums[k] < sums[k - 1]; k--) {
            double sum = sums[k], corner[U];
            memcpy(corner, corners[k], sizeof corner);
            memcpy(corners[k], corners[k - 1], sizeof corner);
            memcpy(corners[k - 1], corner, sizeof corner);
            sums[k] = sums[k - 1];
            sums[k - 1] = sum;
        }
}

/* Evaluates the point that lies `by` times as far behind the middle of the best corners as the worst one is before. */
static bool try_point(Search *search, double corners[U + 1][U], double by, double *point, double *sum) {
    size_t n = search->fit->unknown_count;
    for (size_t i = 0; i < n; i++) {
        double middle = 0;
        for (size_t k = 0; k < n; k++)
            middle += corners[k][i] / (double)n;
        point[i] = i == search->fixed ? corners[0][i] : middle + by * (middle - corners[n][i]);
    }
    if (is_near_prior(point, n))
        return evaluate(search, point, sum);
    *sum = HUGE_VAL;
    return true;
}

static bool shrink(Search *search, double corners[U + 1][U], double sums[U + 1]) {
    size_t n = search->fit->unknown_count;
    for (size_t k = 1; k <= n; k++) {
        for (size_t i = 0; i < n; i++)
            corners[k][i] = (corners[k][i] + corners[0][i]) / 2;
        if (!evaluate(search, corners[k], &sums[k]))
            return false;
    }
    return true;
}

/* The simplex of Nelder and Mead, from u on. */
static bool search_simplex(Search *search, double *u, double *sum) {
    size_t n = search->fit->unknown_count;
    double corners[U + 1][U], sums[U + 1];
    for (size_t k = 0; k <= n; k++) {
        memcpy(corners[k], u, n * sizeof *u);
        if (k > 0 && k - 1 != search->fixed)
            corners[k][k - 1] += 0.15;
        if (!evaluate(search, corners[k], &sums[k]))
            return false;
    }
    for (int step = 0; step < SIMPLEX_STEPS; step++) {
        double point[U], beyond[U], found, farther;
        order_simplex(corners, sums, n);
        if (sums[n] - sums[0] <= SETTLED * (1 + sums[0]))
            break;
        if (!try_point(search, corners, 1, point, &found))
            return false;
        bool best = found < sums[0];
        if (best && !try_point(search, corners, 2, beyond, &farther))
            return false;
        if (best && farther < found) {
            memcpy(point, beyond, sizeof point);
            found = farther;
        } else if (found >= sums[n - 1] && !try_point(search, corners, found < sums[n] ? 0.5 : -0.5, point, &found)) {
            return false;
        }
        if (found < sums[n]) {
            memcpy(corners[n], point, sizeof point);
            sums[n] = found;
        } else if (!shrink(search, corners, sums)) {
            return false;
        }
    }
    order_simplex(corners, sums, n);
    memcpy(u, corners[0], n * sizeof *u);
    return evaluate(search, u, sum);
}

/* Goes downhill from u; leaves the least sum, u, and the values there. */
static bool search_from(Search *search, double *u, double *sum) {
    Fit *fit = search->fit;
    size_t n = fit->unknown_count, refused = 0;
    double *jacobian = memory_zeroed(fit->row_count * n + 1, sizeof *jacobian), mu = 1e-2, normal[U * U], slope[U];
    bool good = evaluate(search, u, sum) && derive(search, u, jacobian), ended = false;
    for (int k = 0; k < STEPS_MOST && good && !ended && refused < REFUSED_MOST; k++) {
        double step[U], next[U], next_sum = HUGE_VAL;
        double *values = memory_zeroed(fit->row_count + 1, sizeof *values),
               *ways = memory_zeroed(fit->row_count + 1, sizeof *ways);
        form_normal(search, u, jacobian, normal, slope);
        if (!solve_step(normal, slope, n, mu, step))
            memset(step, 0, sizeof step);
        for (size_t i = 0; i < n; i++)
            next[i] = u[i] + step[i];
        if (is_near_prior(next, n) && (good = simulate(search, next, 1, values, ways)))
            next_sum = sum_of(search, next, values);
        if (good && next_sum < *sum) {
            ended = *sum - next_sum <= SETTLED * (1 + *sum);
            memcpy(u, next, n * sizeof *u);
            memcpy(search->values, values, fit->row_count * sizeof *values);
            memcpy(search->ways, ways, fit->row_count * sizeof *ways);
            *sum = next_sum;
            mu = fmax(mu / 10, 1e-9);
            refused = 0;
            good = ended || derive(search, u, jacobian);
        } else {
            double size = 0;
            for (size_t i = 0; i < n; i++)
                size = fmax(size, fabs(step[i]));
            ended = size < SETTLED; /* there is no better place near */
            mu *= 10;
            refused++;
        }
        memory_free(values);
        memory_free(ways);
    }
    memory_free(jacobian);
    return good && (ended || refused < REFUSED_MOST || search_simplex(search, u, sum));
}

/* Starts, intervals and checks --------------------------------------------------------------------------------------
 */

/* Returns the root of g^(n+1) = g + 1, n unknowns. */
static double kronecker_root(size_t n) {
    double g = 1.5;
    for (int k = 0; k < 60; k++) {
        double power = 1;
        for (size_t i = 0; i < n; i++)
            power *= g;
        g -= (power * g - g - 1) / ((double)(n + 1) * power - 1);
    }
    return g;
}

static void start_at(const Fit *fit, size_t start, double *u) {
    double g = kronecker_root(fit->unknown_count), power = 1;
    for (size_t i = 0; i < fit->unknown_count; i++) {
        power /= g;
        double part = 0.5 + (double)start * power;
        u[i] = start ? START_REACH * (2 * (part - floor(part)) - 1) : 0;
    }
}

static bool search_all(Search *search, double *best, double *least) {
    Fit *fit = search->fit;
    double found[FIT_STARTS][U], sums[FIT_STARTS];
    size_t starts = fit->starts && fit->starts < FIT_STARTS ? fit->starts : FIT_STARTS, first = 0;
    for (size_t s = 0; s < starts; s++) {
        start_at(fit, s, found[s]);
        if (!search_from(search, found[s], &sums[s]))
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
    return evaluate(search, best, least);
}

/* Returns the standard deviation, in spreads, that follows from the rise of the profile `by` away from the best u. */
static bool profile_at(Search *search, const double *best, double least, size_t unknown, double by, double *deviation) {
    double u[U], sum;
    memcpy(u, best, sizeof u);
    u[unknown] += by;
    search->fixed = unknown;
    bool good = search_from(search, u, &sum);
    search->fixed = SIZE_MAX;
    *deviation = sum > least ? fabs(by) / sqrt(sum - least) : HUGE_VAL;
    return good;
}

static bool find_intervals(Search *search, const double *best, double least) {
    Fit *fit = search->fit;
    size_t n = fit->unknown_count;
    double *jacobian = memory_zeroed(fit->row_count * n + 1, sizeof *jacobian), normal[U * U], slope[U], none[U];
    bool good = derive(search, best, jacobian);
    form_normal(search, best, jacobian, normal, slope);
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
    for (size_t i = 0; i < n && good; i++) {
        FitUnknown *unknown = &fit->unknowns[i];
        double straight = sqrt(normal[i * n + i]), sides[2];
        for (int side = 0; side < 2 && good; side++) {
            good = profile_at(search, best, least, i, (side ? 2 : -2) * straight, &sides[side]);
            bool differs = fabs(sides[side] / straight - 1) > 0.3;
            sides[side] = differs ? fmin(sides[side], 1.0) : straight; /* never wider than the prior */
            unknown->skew |= differs;
        }
        double deviation = sqrt((sides[0] * sides[0] + sides[1] * sides[1]) / 2);
        unknown->deviation = deviation * unknown->spread;
        unknown->learned = 1 - deviation * deviation;
        unknown->told = unknown->learned >= FIT_LEARNED_LEAST;
        unknown->best = value_of(unknown, best[i]);
        unknown->value = unknown->told ? unknown->best : unknown->prior;
        unknown->low = value_of(unknown, best[i] - NINETY * sides[0]);
        unknown->high = value_of(unknown, best[i] + NINETY * sides[1]);
    }
    return good;
}

/* Predicts each group with what the others tell. */
static bool leave_out(Search *search, const double *best) {
    Fit *fit = search->fit;
    size_t groups = 0, counted = 0;
    for (size_t r = 0; r < fit->row_count; r++)
        groups = fit->rows[r].group >= groups ? fit->rows[r].group + 1 : groups;
    for (size_t g = 0; g < groups; g++) {
        double u[U], sum;
        memcpy(u, best, sizeof u);
        search->without = g;
        bool good = search_from(search, u, &sum);
        search->without = SIZE_MAX;
        if (!good)
            return false;
        for (size_t r = 0; r < fit->row_count; r++) {
            FitRow *row = &fit->rows[r];
            if (row->group != g)
                continue;
            row->left_out = search->values[r];
            double now = plain_residual(row, row->left_out), before = plain_residual(row, row->before);
            fit->error += now * now;
            fit->error_before += before * before;
            counted++;
        }
    }
    fit->error = sqrt(fit->error / (double)counted);
    fit->error_before = sqrt(fit->error_before / (double)counted);
    return true;
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

static bool check(const Fit *fit, const double *values, Fault *fault) {
    for (size_t r = 0; r < fit->row_count; r++)
        if (isfinite(values[r]))
            return true;
    fault_add(fault, "nothing can be fitted: no run with the values before the fit has a result to compare");
    return false;
}

static bool fit_with(Search *search, Fault *fault) {
    Fit *fit = search->fit;
    double best[U] = {0}, least;
    if (!evaluate(search, best, &fit->sum_before))
        return true;
    for (size_t r = 0; r < fit->row_count; r++)
        fit->rows[r].before = search->values[r];
    if (!check(fit, search->values, fault))
        return false;
    if (!search_all(search, best, &least))
        return true;
    fit->sum = least;
    for (size_t r = 0; r < fit->row_count; r++) {
        fit->rows[r].simulated = search->values[r];
        fit->rows[r].residual = plain_residual(&fit->rows[r], search->values[r]);
    }
    fit->sign_runs = sign_runs(fit);
    if (find_intervals(search, best, least) && fit->leave_out)
        leave_out(search, best);
    return true;
}

bool fit_run(Fit *fit, Fault *fault) {
    Search search = {.fit = fit, .without = SIZE_MAX, .fixed = SIZE_MAX};
    for (size_t r = 0; r < fit->row_count; r++)
        fit->rows[r].before = fit->rows[r].simulated = fit->rows[r].residual = fit->rows[r].left_out = NAN;
    fit->sum = fit->sum_before = fit->sign_runs = NAN;
    fit->error = fit->error_before = 0;
    search.first = share_runs(fit);
    search.values = memory_zeroed(fit->row_count + 1, sizeof *search.values);
    search.ways = memory_zeroed(fit->row_count + 1, sizeof *search.ways);
    bool good = fit_with(&search, fault);
    memory_free(search.first);
    memory_free(search.values);
    memory_free(search.ways);
    return good;
}
