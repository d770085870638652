/* Measuring: medians of several turns, beside a reference of the same process, since machines are shared and their
 * speed drifts. */
#pragma once

/* s of processor time of this thread, since some moment. */
double bench_now(void);

/* s by the clock, since some moment: for what takes several threads. */
double bench_clock(void);

/* A fixed piece of arithmetic and memory work, the reference: its seconds are what a bench's ratios are made with. */
double bench_reference(void);

/* The middle one of `count` values, which are sorted. */
double bench_median(double *values, int count);
