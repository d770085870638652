/* Searching for the least sum of squares: Levenberg-Marquardt with derivatives by differences and Broyden's rule, and
 * the simplex of Nelder and Mead where the sum has steps. The theory is told in fit.c. */
#include "study/fit_search.h"

#include <lapacke.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/parallel.h"
#include "base/real.h"

static const double STUDENT = 4;       /* degrees of freedom */
static const double NO_VALUE = 10;     /* 1, residual of a run without a value */
static const double DIFFERENCE = 0.02; /* of a logarithm, to both sides */
static const double FARTHEST = 4;      /* spreads from the prior that are looked at */
static const double WORTH = 0.5;       /* fall of the sum for which a simplex is tried */
static const double SETTLED = 5e-4;    /* of the sum: numerics, when a search has ended */

enum { STEPS_MOST = 25, REFUSED_MOST = 3, SIMPLEX_STEPS = 40, U = FIT_UNKNOWNS_MOST };

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

void fit_search_begin(FitSearch *search, Fit *fit) {
    *search = (FitSearch){.fit = fit, .first = share_runs(fit), .without = SIZE_MAX, .fixed = SIZE_MAX};
    search->values = memory_zeroed(fit->row_count + 1, sizeof *search->values);
    search->ways = memory_zeroed(fit->row_count + 1, sizeof *search->ways);
}

void fit_search_end(FitSearch *search) {
    memory_free(search->first);
    memory_free(search->values);
    memory_free(search->ways);
}

double fit_search_value(const FitUnknown *unknown, double u) {
    return unknown->prior * real_exp(u * unknown->spread);
}

/* Points at which all rows are simulated. */
typedef struct Sites {
    const FitSearch *search;
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
            own[row->name_count + i] = fit_search_value(&fit->unknowns[i], sites->at[point * U + i]);
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
static bool simulate(FitSearch *search, const double *at, size_t count, double *values, double *ways) {
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

double fit_search_residual(const FitRow *row, double value) {
    if (!isfinite(value) || (row->relative && !(value > 0)))
        return NO_VALUE;
    double off = row->relative ? real_log(value / row->observed) : value - row->observed;
    return off / row->deviation;
}

static double residual_of(const FitSearch *search, size_t row, double value) {
    if (search->fit->rows[row].group == search->without)
        return 0;
    double r = fit_search_residual(&search->fit->rows[row], value);
    if (!search->fit->robust)
        return r;
    double size = sqrt((STUDENT + 1) * real_log1p(r * r / STUDENT));
    return r < 0 ? -size : size;
}

/* Returns the sum of squares of the rows and of the priors. */
static double sum_of(const FitSearch *search, const double *u, const double *values) {
    double sum = 0;
    for (size_t r = 0; r < search->fit->row_count; r++) {
        double residual = residual_of(search, r, values[r]);
        sum += residual * residual;
    }
    for (size_t i = 0; i < search->fit->unknown_count; i++)
        sum += u[i] * u[i];
    return sum;
}

bool fit_search_evaluate(FitSearch *search, const double *u, double *sum) {
    if (!simulate(search, u, 1, search->values, search->ways))
        return false;
    *sum = sum_of(search, u, search->values);
    return true;
}

bool fit_search_sums(FitSearch *search, const double *at, size_t count, double *sums, double *values) {
    size_t rows = search->fit->row_count;
    double *ways = memory_zeroed(count * rows + 1, sizeof *ways);
    bool good = simulate(search, at, count, values, ways);
    for (size_t p = 0; p < count && good; p++)
        sums[p] = sum_of(search, at + p * U, values + p * rows);
    memory_free(ways);
    return good;
}

double fit_search_square(const FitSearch *search, size_t row, double value) {
    double residual = residual_of(search, row, value);
    return residual * residual;
}

/* Returns the root of g^(n+1) = g + 1, n dimensions. */
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

void fit_search_kronecker(size_t dimensions, size_t nth, double *place) {
    double g = kronecker_root(dimensions), power = 1;
    for (size_t i = 0; i < dimensions; i++) {
        power /= g;
        place[i] = 0.5 + (double)nth * power;
        place[i] -= floor(place[i]);
    }
}

/* Fills in the derivatives (row_count x unknown_count, column by column) at u, where search->values are known. */
bool fit_search_derive(FitSearch *search, const double *u, double *jacobian) {
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
void fit_search_form_normal(const FitSearch *search, const double *u, const double *jacobian, double *normal,
                            double *slope) {
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
static bool try_point(FitSearch *search, double corners[U + 1][U], double by, double *point, double *sum) {
    size_t n = search->fit->unknown_count;
    for (size_t i = 0; i < n; i++) {
        double middle = 0;
        for (size_t k = 0; k < n; k++)
            middle += corners[k][i] / (double)n;
        point[i] = i == search->fixed ? corners[0][i] : middle + by * (middle - corners[n][i]);
    }
    if (is_near_prior(point, n))
        return fit_search_evaluate(search, point, sum);
    *sum = HUGE_VAL;
    return true;
}

static bool shrink(FitSearch *search, double corners[U + 1][U], double sums[U + 1]) {
    size_t n = search->fit->unknown_count;
    for (size_t k = 1; k <= n; k++) {
        for (size_t i = 0; i < n; i++)
            corners[k][i] = (corners[k][i] + corners[0][i]) / 2;
        if (!fit_search_evaluate(search, corners[k], &sums[k]))
            return false;
    }
    return true;
}

/* The simplex of Nelder and Mead, from u on. */
static bool search_simplex(FitSearch *search, double *u, double *sum) {
    size_t n = search->fit->unknown_count;
    double corners[U + 1][U], sums[U + 1];
    for (size_t k = 0; k <= n; k++) {
        memcpy(corners[k], u, n * sizeof *u);
        if (k > 0 && k - 1 != search->fixed)
            corners[k][k - 1] += 0.15;
        if (!fit_search_evaluate(search, corners[k], &sums[k]))
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
    return fit_search_evaluate(search, u, sum);
}

/* Brings the derivatives up to date after a step (Broyden 1965): the least change with which they explain it. */
static void learn_derivatives(const FitSearch *search, const double *before, const double *step, double *jacobian) {
    size_t n = search->fit->unknown_count, rows = search->fit->row_count;
    double square = 0;
    for (size_t i = 0; i < n; i++)
        square += step[i] * step[i];
    for (size_t r = 0; r < rows && square > 0; r++) {
        double rest = residual_of(search, r, search->values[r]) - residual_of(search, r, before[r]);
        for (size_t i = 0; i < n; i++)
            rest -= jacobian[i * rows + r] * step[i];
        for (size_t i = 0; i < n; i++)
            jacobian[i * rows + r] += rest * step[i] / square;
    }
}

/* Returns by how much the sum should fall with a step. */
static double expected_fall(const double *normal, const double *slope, const double *step, size_t n) {
    double fall = 0;
    for (size_t i = 0; i < n; i++) {
        fall -= 2 * slope[i] * step[i];
        for (size_t j = 0; j < n; j++)
            fall -= step[i] * normal[i * n + j] * step[j];
    }
    return fall;
}

/* Where a search is. */
typedef struct Descent {
    double *u, *sum;
    double *jacobian, *before; /* derivatives at u; (row_count) values before the last step */
    double mu;
    int refused;  /* steps that did not lower the sum, since one did */
    bool learned; /* True if the derivatives were brought up to date, not computed again */
    bool ended;
    double hoped; /* fall of the sum that the last refused step promised */
} Descent;

/* Takes a step if it lowers the sum; false: interrupted. */
static bool descend(FitSearch *search, Descent *descent) {
    size_t n = search->fit->unknown_count, rows = search->fit->row_count;
    double normal[U * U], slope[U], step[U], next[U], sum = HUGE_VAL, known = *descent->sum;
    fit_search_form_normal(search, descent->u, descent->jacobian, normal, slope);
    if (!solve_step(normal, slope, n, descent->mu, step))
        memset(step, 0, sizeof step);
    for (size_t i = 0; i < n; i++)
        next[i] = descent->u[i] + step[i];
    descent->hoped = expected_fall(normal, slope, step, n);
    descent->ended = descent->hoped < SETTLED * (1 + known);
    if (descent->ended)
        return true;
    memcpy(descent->before, search->values, rows * sizeof *descent->before);
    if (is_near_prior(next, n) && !fit_search_evaluate(search, next, &sum))
        return false;
    if (sum < known) {
        learn_derivatives(search, descent->before, step, descent->jacobian);
        memcpy(descent->u, next, n * sizeof *next);
        *descent->sum = sum;
        descent->learned = true;
        descent->refused = 0;
        descent->mu = fmax(descent->mu / 10, 1e-9);
        return true;
    }
    memcpy(search->values, descent->before, rows * sizeof *descent->before);
    if (descent->learned) {
        descent->learned = false;
        return fit_search_evaluate(search, descent->u, descent->sum) &&
               fit_search_derive(search, descent->u, descent->jacobian);
    }
    descent->mu *= 10;
    descent->refused++;
    return true;
}

/* Goes downhill from u; leaves the least sum, u, and the values there. */
bool fit_search_from(FitSearch *search, double *u, double *sum) {
    Fit *fit = search->fit;
    Descent descent = {.u = u, .sum = sum, .mu = 1e-2};
    size_t count = fit->row_count * fit->unknown_count;
    descent.jacobian = memory_zeroed(count + 1, sizeof *descent.jacobian);
    descent.before = memory_zeroed(fit->row_count + 1, sizeof *descent.before);
    bool good = fit_search_evaluate(search, u, sum);
    if (good && search->derivatives) {
        memcpy(descent.jacobian, search->derivatives, count * sizeof *descent.jacobian);
        descent.learned = true;
    } else {
        good = good && fit_search_derive(search, u, descent.jacobian);
    }
    for (int k = 0; k < STEPS_MOST && good && !descent.ended && descent.refused < REFUSED_MOST; k++)
        good = descend(search, &descent);
    bool jumps = !descent.ended && descent.refused == REFUSED_MOST && descent.hoped > WORTH;
    if (search->kept)
        memcpy(search->kept, descent.jacobian, count * sizeof *descent.jacobian);
    memory_free(descent.jacobian);
    memory_free(descent.before);
    return good && (!jumps || search_simplex(search, u, sum));
}
