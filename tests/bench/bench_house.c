/* Measures one chair in the ube house on one core: simulated seconds per second of the step alone, and the time from
 * file to answer with the fraction of each part. */

#include <stdio.h>
#include <string.h>

#include "bench.h"
#include "house/observer.h"
#include "house/phase.h"
#include "house/step.h"
#include "house/world.h"
#include "houses.h"

enum { TURNS = 15, PARTS = 5 };

static const char *const part_names[PARTS] = {"read, unite, distances", "route search", "track", "steps", "observing"};

static const bool *only(const House *house, const char *route) {
    static bool part[64];
    for (size_t i = 0; i < house->person_count; i++)
        part[i] = house->people[i].route && strcmp(house->people[i].route->id, route) == 0;
    return part;
}

/* Measures the time of each part, s; returns the simulated time. */
static double one_turn(const char *source, const char *route, double seconds[PARTS]) {
    House house = {.seed = 0};
    double begin = bench_now();
    houses_read_ube(&house, source);
    seconds[0] = bench_now() - begin;
    const bool *part = only(&house, route);
    begin = bench_now();
    Journeys journeys = journey_plan_all(&house, part, 1, NULL);
    seconds[1] = bench_now() - begin;
    size_t who = 0;
    while (!part[who])
        who++;
    Track again = {0};
    begin = bench_now();
    track_build_driver(&again, &house, &house.people[who], &journeys.of[who].route);
    seconds[2] = bench_now() - begin;
    seconds[1] -= seconds[2];
    track_free(&again);
    World world = world_create(&house, journeys.of, part), twin = world_copy(&world);
    begin = bench_now();
    while (phase_any_active(&world))
        step_world(&world, NULL);
    seconds[3] = bench_now() - begin;
    PersonObservation *people = memory_zeroed(house.person_count, sizeof *people);
    Observer observer;
    observer_init(&observer, &twin, people);
    begin = bench_now();
    while (phase_any_active(&twin)) {
        step_world(&twin, NULL);
        observer_watch(&observer);
    }
    seconds[4] = bench_now() - begin - seconds[3];
    double simulated = clock_time(&world.clock);
    observer_clear(&observer);
    memory_free(people);
    world_destroy(&twin);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
    return simulated;
}

int main(int argc, char **argv) {
    const char *source = argc > 1 ? argv[1] : ".";
    static const char *const routes[] = {"A", "B", "C", "D"};
    printf("one chair in the ube house, step 1 ms, one core, median of %d; steps without observing\n\n", TURNS);
    printf("route  simulated s  simulated s per s  steps per s   file to answer ms   parts ms:");
    for (int p = 0; p < PARTS; p++)
        printf(" %s%s", part_names[p], p + 1 < PARTS ? "," : "\n");
    double reference[TURNS];
    for (size_t r = 0; r < sizeof routes / sizeof *routes; r++) {
        double parts[PARTS][TURNS], whole[TURNS], simulated = 0;
        for (int turn = 0; turn < TURNS; turn++) {
            double seconds[PARTS] = {0};
            simulated = one_turn(source, routes[r], seconds);
            whole[turn] = 0;
            for (int p = 0; p < PARTS; p++) {
                parts[p][turn] = seconds[p];
                whole[turn] += seconds[p];
            }
            reference[turn] = bench_reference();
        }
        double steps = bench_median(parts[3], TURNS);
        printf("%-5s  %11.2f  %17.0f  %11.0f  %18.1f           ", routes[r], simulated, simulated / steps,
               1000 * simulated / steps, 1000 * bench_median(whole, TURNS));
        for (int p = 0; p < PARTS; p++)
            printf(" %.2f", 1000 * bench_median(parts[p], TURNS));
        printf("\n");
    }
    printf("\nreference (8 million dependent square roots): %.1f ms\n", 1000 * bench_median(reference, TURNS));
    return 0;
}
