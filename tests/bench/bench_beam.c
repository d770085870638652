/* Measures the impact beam: cycles of the drive per second on one core, with 4 and 12 modes, alone and in lanes; an
 * orbit diagram and a map on all cores, and how long it takes to confirm chaos. */

#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "beam/beam_cycle.h"
#include "beam/lanes.h"
#include "bench.h"

enum { TURNS = 9, CYCLES = 2000, BATCH = 32 };

static Rig make_rig(const char *source, const char *modes) {
    char path[4096];
    Beam beam = {0};
    Fault fault = {0};
    Rig rig;
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", source);
    if (!beam_read(&beam, path, &modes, 1, &fault) || !rig_build(&rig, &beam, path, &fault)) {
        printf("%s\n", fault.lines[0]);
        exit(1);
    }
    beam_free(&beam);
    return rig;
}

static void measure(const char *source, const char *modes, double frequency) {
    Rig rig = make_rig(source, modes);
    rig_drive(&rig, frequency, rig.force);
    Motion motion = motion_create(&rig, 0);
    for (int i = 0; i < 300; i++)
        motion_cycle(&motion);
    double seconds[TURNS];
    size_t switches = motion.switches;
    for (int turn = 0; turn < TURNS; turn++) {
        double begin = bench_now();
        for (int i = 0; i < CYCLES; i++)
            motion_cycle(&motion);
        seconds[turn] = bench_now() - begin;
    }
    printf("%-14s %4.0f Hz  %8.0f cycles/s  %5.1f switches and %4.0f cells a cycle\n", modes, frequency,
           CYCLES / bench_median(seconds, TURNS), (double)(motion.switches - switches) / (TURNS * CYCLES),
           rig.period / rig.cell);
    motion_destroy(&motion);
    rig_clear(&rig);
}

/* Runs that are distributed to threads in batches. */
typedef struct Batches {
    const Rig *rig;
    LanesRun *runs;
    size_t count;
} Batches;

static void run_batch(void *context, size_t index) {
    const Batches *batches = context;
    size_t from = index * BATCH, left = batches->count - from;
    lanes_run(batches->rig, batches->runs + from, left < BATCH ? left : BATCH, NULL);
}

/* `rows` clearances up to the beam's own, with `columns` frequencies from `low` to 320 Hz, from rest, 300 + 100 cycles
 * a point: s on one core, and by the clock with all. */
static void measure_map(const char *source, const char *modes, double low, size_t columns, size_t rows, bool alone) {
    Rig rig = make_rig(source, modes);
    Batches batches = {&rig, memory_zeroed(columns * rows, sizeof(LanesRun)), columns * rows};
    for (size_t i = 0; i < batches.count; i++)
        batches.runs[i] = (LanesRun){
            .frequency = low + (320 - low) * (double)(i % columns) / (double)(columns - 1),
            .force = rig.force,
            .clearance = rig.clearance * (double)(i / columns + 1) / (double)rows,
            .transient_cycles = 300,
            .cycles = 100,
        };
    double cycles = 400 * (double)batches.count, begin = bench_now();
    printf("%-14s %zu x %zu points", modes, columns, rows);
    if (alone) {
        lanes_run(&rig, batches.runs, batches.count, NULL);
        double seconds = bench_now() - begin;
        printf("  %8.0f cycles/s in lanes on one core, %.2f s", cycles / seconds, seconds);
    }
    begin = bench_clock();
    parallel_for(parallel_processors(), (batches.count + BATCH - 1) / BATCH, run_batch, &batches);
    double seconds = bench_clock() - begin;
    printf("  %8.0f on all by the clock, %.2f s\n", cycles / seconds, seconds);
    memory_free(batches.runs);
    rig_clear(&rig);
}

/* Confirms that set B with 12 modes is chaotic at 300 Hz: s of this thread and by the clock. */
static void measure_survival(const char *source) {
    char path[4096];
    Beam beam = {0};
    Fault fault = {0};
    Rig rig;
    Response response;
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", source);
    if (!beam_read(&beam, path, NULL, 0, &fault) || !rig_build(&rig, &beam, path, &fault))
        exit(1);
    beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
    double begin = bench_now(), clock = bench_clock();
    response_confirm(&response, beam_cycle_of(&rig),
                     &(SurvivalTask){SURVIVAL_LANES, SURVIVAL_CYCLES, parallel_processors(), NULL});
    printf("%d motions of %d cycles: %.1f s of this thread, %.1f s by the clock on all cores\n", SURVIVAL_LANES,
           SURVIVAL_CYCLES, bench_now() - begin, bench_clock() - clock);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

int main(int argc, char **argv) {
    if (argc < 2)
        return 2;
    double reference[TURNS];
    for (int turn = 0; turn < TURNS; turn++)
        reference[turn] = bench_reference();
    static const char *const modes[] = {"beam.modes=4", "beam.modes=12"};
    for (int i = 0; i < 2; i++) {
        measure(argv[1], modes[i], 190);
        measure(argv[1], modes[i], 300);
        measure_map(argv[1], modes[i], 20, 301, 1, true);
        measure_map(argv[1], modes[i], 120, 200, 100, false);
    }
    measure_survival(argv[1]);
    printf("reference (8 million dependent square roots): %.1f ms\n", 1000 * bench_median(reference, TURNS));
    return 0;
}
