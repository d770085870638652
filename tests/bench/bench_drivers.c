/* Measures a hundred drivers of the population "manual-jp" in the ube house: processor time of one thread, as a ratio
 * to the reference and for each driver on a route, and the clock time of two threads. */

#include <stdio.h>

#include "bench.h"
#include "experiment/drivers.h"
#include "houses.h"

enum { DRIVERS = 100, TURNS = 3, PATH = 4200 };

/* Runs all drivers and returns the time by the given clock, s. */
static double one_turn(const House *house, const Population *population, int jobs, double (*now)(void), size_t *plans) {
    Drivers drivers;
    double begin = now();
    drivers_run(&drivers, house, population, DRIVERS, SIZE_MAX, jobs, NULL);
    double seconds = now() - begin;
    *plans = drivers.plans;
    drivers_free(&drivers);
    return seconds;
}

int main(int argc, char **argv) {
    const char *source = argc > 1 ? argv[1] : ".";
    char path[PATH];
    House house = {.seed = 0};
    Population population = {0};
    Fault fault = {0};
    double one[TURNS], two[TURNS], reference[TURNS];
    size_t plans = 0;
    houses_read_ube(&house, source);
    snprintf(path, sizeof path, "%s/assets/populations/manual-jp.json", source);
    if (!population_read(&population, path, &fault)) {
        fprintf(stderr, "%s\n", fault.lines[0]);
        return 1;
    }
    for (int turn = 0; turn < TURNS; turn++) {
        reference[turn] = bench_reference();
        one[turn] = one_turn(&house, &population, 1, bench_now, &plans);
        two[turn] = one_turn(&house, &population, 2, bench_clock, &plans);
    }
    double work = bench_median(one, TURNS);
    size_t runs = DRIVERS * house.person_count;
    printf("%d drivers on %zu routes, %zu ways planned: %.2f s of one processor, %.1f references\n", DRIVERS,
           house.person_count, plans, work, work / bench_median(reference, TURNS));
    printf("%.1f ms a driver and route; with two threads %.2f s by the clock\n", 1000 * work / (double)runs,
           bench_median(two, TURNS));
    population_free(&population);
    house_free(&house);
    return 0;
}
