/* Measures the time from an edit to the complete answer with two threads: the wardrobe of the ube house is dragged
 * along a line, and after each step the house is read from its text and simulated; then the time to report a door
 * that is too narrow, briefly and in full. */

#include <stdint.h>
#include <stdio.h>

#include "bench.h"
#include "house/run.h"
#include "houses.h"

enum { STEPS = 200, TURNS = 3, PARTS = 3 };

/* m: the wardrobe's centre at the beginning and the end of the drag. */
static const double FROM = 8.4, TO = 9.6;

static const char *const part_names[PARTS] = {"whole", "read", "run"};

typedef struct Drag {
    Plan plan;
    Furniture *piece;
    HouseOptions options;
    char profiles[4096];
} Drag;

static void begin_drag(Drag *drag, const char *source) {
    House house = {.seed = 0};
    houses_read_ube(&house, source);
    char *text = plan_text(&house.plan);
    Fault fault = {0};
    *drag = (Drag){.options = {.seed = 1, .driving = -1}};
    snprintf(drag->profiles, sizeof drag->profiles, "%s/assets/profiles", source);
    plan_read_text(&drag->plan, "ube.json", text, NULL, 0, &fault);
    for (size_t f = 0; f < drag->plan.furniture_count; f++)
        if (drag->plan.furniture[f].centre.y > 8.7 && drag->plan.furniture[f].centre.x > 9)
            drag->piece = &drag->plan.furniture[f];
    memory_free(text);
    fault_clear(&fault);
    house_free(&house);
}

static void one_step(Drag *drag, int step, double seconds[PARTS]) {
    House house = {.seed = 0};
    Fault fault = {0};
    Observation observation;
    drag->piece->centre.x = FROM + (TO - FROM) * step / (STEPS - 1);
    drag->options.profiles = drag->profiles;
    double begin = bench_clock();
    char *text = plan_text(&drag->plan);
    house_read_text(&house, "ube.json", text, &drag->options, &fault);
    double read = bench_clock();
    run_house(&observation, &house, &(RunOptions){.route = SIZE_MAX, .jobs = 2});
    double end = bench_clock();
    seconds[0] = end - begin;
    seconds[1] = read - begin;
    seconds[2] = end - read;
    observation_free(&observation);
    house_free(&house);
    fault_clear(&fault);
    memory_free(text);
}

/* Returns the median time until a chair is known not to pass a door, s. */
static double say_no(const char *source, bool brief) {
    static const char *const settings[] = {"door.d1.width=0.6"};
    char path[4096], profiles[4096];
    double seconds[TURNS];
    snprintf(path, sizeof path, "%s/houses/closed-door.json", source);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", source);
    for (int turn = 0; turn < TURNS; turn++) {
        House house = {.seed = 0};
        Fault fault = {0};
        Observation observation;
        HouseOptions options = {.profiles = profiles, .settings = settings, .setting_count = 1, .driving = -1};
        double begin = bench_clock();
        house_read(&house, path, &options, &fault);
        run_house(&observation, &house, &(RunOptions){.route = SIZE_MAX, .jobs = 2, .brief = brief});
        seconds[turn] = bench_clock() - begin;
        observation_free(&observation);
        house_free(&house);
        fault_clear(&fault);
    }
    return bench_median(seconds, TURNS);
}

int main(int argc, char **argv) {
    const char *source = argc > 1 ? argv[1] : ".";
    Drag drag;
    double parts[PARTS][STEPS], reference[TURNS];
    begin_drag(&drag, source);
    for (int turn = 0; turn < TURNS; turn++) { /* clock time, as the rest */
        double begin = bench_clock();
        bench_reference();
        reference[turn] = bench_clock() - begin;
    }
    double unit = bench_median(reference, TURNS);
    for (int step = 0; step < STEPS; step++) {
        double seconds[PARTS];
        one_step(&drag, step, seconds);
        for (int p = 0; p < PARTS; p++)
            parts[p][step] = seconds[p];
    }
    printf("edit to answer in the ube house, %d steps of a drag, two threads\n\n", STEPS);
    printf("       median ms   99th percentile ms   median in references\n");
    for (int p = 0; p < PARTS; p++) {
        double median = bench_median(parts[p], STEPS);
        printf("%-5s  %9.1f  %19.1f  %21.2f\n", part_names[p], 1000 * median, 1000 * parts[p][STEPS * 99 / 100],
               median / unit);
    }
    printf("\na door too narrow for the chair: said briefly after %.1f ms, in full after %.1f ms\n",
           1000 * say_no(source, true), 1000 * say_no(source, false));
    printf("reference (8 million dependent square roots): %.1f ms\n", 1000 * unit);
    plan_free(&drag.plan);
    return 0;
}
