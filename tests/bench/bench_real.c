/* Elementary functions: the largest error over ten million arguments of each kind, and ns a call beside the C
 * library's. */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "accuracy.h"
#include "bench.h"

enum { TURNS = 9, CALLS = 4096, REPEATS = 50 };

static double seconds_of(double (*function)(double, double), const double *x, const double *y) {
    volatile double sink;
    double begin = bench_now();
    for (int r = 0; r < REPEATS; r++) {
        double sum = 0;
        for (int i = 0; i < CALLS; i++)
            sum += function(x[i], y[i]);
        sink = sum;
    }
    (void)sink;
    return bench_now() - begin;
}

int main(int argc, char **argv) {
    long arguments = argc > 2 ? atol(argv[2]) : 10000000;
    static double x[CALLS], y[CALLS];
    double own[TURNS], library[TURNS];
    for (size_t i = 0; i < accuracy_count; i++) {
        const AccuracyCase *what = &accuracy_list[i];
        uint64_t state = 5;
        for (int k = 0; k < CALLS; k++)
            what->draw(&state, &x[k], &y[k]);
        for (int turn = 0; turn < TURNS; turn++) {
            own[turn] = seconds_of(what->own, x, y);
            library[turn] = seconds_of(what->library, x, y);
        }
        double to_ns = 1e9 / ((double)CALLS * REPEATS), own_ns = bench_median(own, TURNS) * to_ns;
        double library_ns = bench_median(library, TURNS) * to_ns;
        Accuracy found = accuracy_measure(what, arguments);
        printf("%-28s error %.4f of a last place, at %a %a; %5.1f ns a call, the C library's %5.1f\n", what->name,
               found.worst, found.x, found.y, own_ns, library_ns);
        fflush(stdout);
    }
    return 0;
}
