/* Dormand and Prince's explicit Runge-Kutta method of order 8 with embedded errors of orders 5 and 3, one step at a
 * time.
 *
 * Source: Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", 2nd edition, section II.5, and the
 * coefficients of their public DOP853. The stepper knows only a right side; its caller decides which steps to
 * keep, so that a step can be repeated to the instant of a switch. Sums are in a fixed order: the same bits on every
 * machine. */
#pragma once

#include <stddef.h>

enum { STEPPER_STATES_MOST = 48 /* fewer than this */ };

typedef struct Stepper {
    size_t states;
    const double *scale; /* (states) the error of each state that counts as 1 */
    double tolerance;    /* 1, of the scaled error of a step */
    void (*rates)(const void *system, double time, const double *state, double *rates);
    const void *system;
} Stepper;

/* Evaluations of the right side by one step: its beginning is known, and its end is the next one's beginning. */
enum { STEPPER_EVALUATIONS = 12 };

/* Computes `next` and `next_rates` (states each) after `step` s from a state and its rates. Returns the error over the
 * tolerance: a step above 1 should be repeated with stepper_next; NaN when a number is not finite. */
double stepper_try(const Stepper *stepper, double time, double step, const double *state, const double *rates,
                   double *next, double *next_rates);

/* Returns the length of the step to take after one of length `step` with that error. */
double stepper_next(double step, double error);
