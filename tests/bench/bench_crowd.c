/* Measures crowds: agent-steps per second on one core for people on foot and in chairs, the cost of observing, the
 * gain of a second thread, and memory per person. Discs overlap personal spaces at every step; the step is 1 ms, and
 * neighbour lists are exact to WALKERS_SKIN. */

#include <malloc.h>
#include <stdio.h>

#include "bench.h"
#include "house/observer.h"
#include "house/step.h"
#include "house/world.h"
#include "houses.h"

enum { TURNS = 5 };

typedef struct Scene {
    const char *name, *profile;
    double side, density; /* m, 1/m2 */
    int steps;            /* measured in one turn */
} Scene;

static const Scene scenes[] = {
    {"1,000 adults at 1 per m2", "adult", 31.63, 1, 2000},
    {"10,000 adults at 1 per m2", "adult", 100, 1, 300},
    {"1,000 adults at 3 per m2, queueing", "adult", 18.26, 3, 2000},
    {"10,000 adults at 3 per m2, queueing", "adult", 57.74, 3, 300},
    {"100 manual chairs at 0.1 per m2", "manual-chair", 31.63, 0.1, 2000},
};

static size_t memory_used(void) {
    struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

/* Returns the steps of all present people in one turn. */
static double walk_on(World *world, int steps, Observer *observer) {
    double agents = 0;
    for (int step = 0; step < steps; step++) {
        agents += (double)world->present_count;
        step_world(world, NULL);
        if (observer)
            observer_watch(observer);
    }
    return agents;
}

static void measure(const Scene *scene, const char *source) {
    House house;
    houses_read_hall(&house, source, scene->profile, scene->side, scene->density);
    Journeys journeys = journey_plan_all(&house, NULL, parallel_processors(), NULL);
    size_t before = memory_used();
    World world = world_create(&house, journeys.of, NULL);
    walk_on(&world, 1000, NULL); /* until all people move */
    double memory = (double)(memory_used() - before) / (double)house.person_count;
    double alone[TURNS], watched[TURNS], together[TURNS], single[TURNS], reference[TURNS];
    ParallelTeam *team = parallel_team_create(2);
    for (int turn = 0; turn < TURNS; turn++) {
        World one = world_copy(&world), two = world_copy(&world), seen = world_copy(&world);
        double begin = bench_now(), clock = bench_clock();
        double agents = walk_on(&one, scene->steps, NULL);
        alone[turn] = agents / (bench_now() - begin);
        single[turn] = bench_clock() - clock;
        two.team = team;
        clock = bench_clock();
        walk_on(&two, scene->steps, NULL);
        together[turn] = single[turn] / (bench_clock() - clock);
        PersonObservation *people = memory_zeroed(house.person_count, sizeof *people);
        Observer observer;
        observer_init(&observer, &seen, people);
        begin = bench_now();
        walk_on(&seen, scene->steps, &observer);
        watched[turn] = scene->steps * world.clock.dt / (bench_now() - begin);
        observer_clear(&observer);
        memory_free(people);
        world_destroy(&one);
        world_destroy(&two);
        world_destroy(&seen);
        reference[turn] = bench_reference();
    }
    printf("%-38s %8.2f   %13.2f   %13.2f   %12.0f   %10.1f\n", scene->name, 1e-6 * bench_median(alone, TURNS),
           bench_median(watched, TURNS), bench_median(together, TURNS), memory, 1000 * bench_median(reference, TURNS));
    parallel_team_destroy(team);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

int main(int argc, char **argv) {
    const char *source = argc > 1 ? argv[1] : ".";
    printf(
        "step 1 ms, median of %d; agent-steps of one core and steps alone; simulated s per s with observing and the\n"
        "trace; two threads against one by the clock (shared machine); bytes of a world per person\n\n",
        TURNS);
    printf("%-38s %8s   %13s   %13s   %12s   %10s\n", "", "M/s", "simulated s/s", "two threads x", "bytes/person",
           "reference ms");
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++)
        measure(&scenes[s], source);
    return 0;
}
