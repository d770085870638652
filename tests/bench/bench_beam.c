/* The impact beam: cycles of the drive per second of one core, with 4 and 12 modes, alone and in lanes; an orbit
 * diagram and a map on all. */

#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "beam/lanes.h"
#include "bench.h"

enum { TURNS = 9, CYCLES = 2000, SWEEP = 301, SWEEP_TURNS = 3 };

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

/* A sweep from rest, 20 to 320 Hz, 300 + 100 cycles a point, in lanes on one core. */
static void measure_lanes(const char *source, const char *modes) {
    Rig rig = make_rig(source, modes);
    LanesRun *runs = memory_allocate(SWEEP, sizeof *runs);
    double seconds[SWEEP_TURNS];
    for (int turn = 0; turn < SWEEP_TURNS; turn++) {
        for (size_t i = 0; i < SWEEP; i++)
            runs[i] = (LanesRun){.frequency = 20 + (double)i,
                                 .force = rig.force,
                                 .clearance = rig.clearance,
                                 .transient_cycles = 300,
                                 .cycles = 100};
        double begin = bench_now();
        lanes_run(&rig, runs, SWEEP, NULL);
        seconds[turn] = bench_now() - begin;
    }
    printf("%-14s sweep   %8.0f cycles/s in lanes on one core\n", modes,
           SWEEP * 400 / bench_median(seconds, SWEEP_TURNS));
    memory_free(runs);
    rig_clear(&rig);
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
        measure_lanes(argv[1], modes[i]);
    }
    printf("reference (8 million dependent square roots): %.1f ms\n", 1000 * bench_median(reference, TURNS));
    return 0;
}
