/* Measures medians of several turns and a reference in the same process, since shared machines change their speed. */
#pragma once

/* Returns the processor time of this thread, s. */
double bench_now(void);

/* Returns the clock time, s, for work of several threads. */
double bench_clock(void);

/* Runs a fixed piece of arithmetic and memory work and returns its time, s: the reference of all ratios. */
double bench_reference(void);

/* Sorts `count` values and returns the middle one. */
double bench_median(double *values, int count);
