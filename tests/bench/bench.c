#include "bench.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

static double read_clock(clockid_t id) {
    struct timespec now;
    clock_gettime(id, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double bench_now(void) {
    return read_clock(CLOCK_THREAD_CPUTIME_ID);
}

double bench_clock(void) {
    return read_clock(CLOCK_MONOTONIC);
}

double bench_reference(void) {
    enum { CELLS = 4096, ROUNDS = 2000 };
    static volatile double sink;
    double cells[CELLS], begin = bench_now();
    for (int i = 0; i < CELLS; i++)
        cells[i] = i;
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 1; i < CELLS; i++)
            cells[i] = sqrt(cells[i - 1] * cells[i - 1] + cells[i]) * 0.5;
    sink = cells[CELLS - 1];
    (void)sink;
    return bench_now() - begin;
}

static int compare_values(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

double bench_median(double *values, int count) {
    qsort(values, (size_t)count, sizeof *values, compare_values);
    return values[count / 2];
}
