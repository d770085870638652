/* Searches for the least sum of squares of a fit. */
#pragma once

#include "study/fit.h"

/* A search: the fit, with which rows and unknowns. */
typedef struct FitSearch {
    Fit *fit;
    size_t *first;             /* (row_count) row whose run this row shares */
    size_t without;            /* group that is left out; SIZE_MAX: none */
    size_t fixed;              /* unknown that is held; SIZE_MAX: none */
    double *values;            /* (row_count) simulated */
    double *ways;              /* (row_count) */
    const double *derivatives; /* (row_count x unknown_count) to begin with; NULL: computed at the start */
    double *kept;              /* receives those at the end of a search; NULL: not */
} FitSearch;

/* Begins with all rows and unknowns; the fit must outlive the search. fit_search_end releases it. */
void fit_search_begin(FitSearch *search, Fit *fit);
void fit_search_end(FitSearch *search);

/* Returns the value of an unknown at u. */
double fit_search_value(const FitUnknown *unknown, double u);

/* Returns (value - observed) / deviation, of logarithms where the row is relative; a large number without a value. */
double fit_search_residual(const FitRow *row, double value);

/* Simulates all rows at u (unknown_count) and sums the squares up, the priors' own among them. Returns false after an
 * interruption, as the next ones. */
bool fit_search_evaluate(FitSearch *search, const double *u, double *sum);

/* Simulates all rows at `count` points (count x FIT_UNKNOWNS_MOST): the sums (count) and the values (count x
 * row_count).
 */
bool fit_search_sums(FitSearch *search, const double *at, size_t count, double *sums, double *values);

/* Returns the square of a row's residual as it counts in the sum. */
double fit_search_square(const FitSearch *search, size_t row, double value);

/* Writes the nth point (n = 0, 1, ...) of the Kronecker sequence of `dimensions` within 0 and 1. */
void fit_search_kronecker(size_t dimensions, size_t nth, double *place);

/* Fills in the derivatives of the residuals (row_count x unknown_count, column by column) at u, which was evaluated
 * last. */
bool fit_search_derive(FitSearch *search, const double *u, double *jacobian);

/* Forms J^T J (unknown_count x unknown_count) with the priors' rows, and J^T r. */
void fit_search_form_normal(const FitSearch *search, const double *u, const double *jacobian, double *normal,
                            double *slope);

/* Goes downhill from u; leaves the least sum, u, and the values there. */
bool fit_search_from(FitSearch *search, double *u, double *sum);
