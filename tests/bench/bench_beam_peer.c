/* Compares the impact beam with 4 modes on one core, swept from 20 to 320 Hz in lanes, with CVODE (Adams, root-
 * finding) on the same model and initial states at every thirtieth frequency, in one process. */

#include <stdio.h>

#include "base/memory.h"
#include "beam/lanes.h"
#include "bench.h"
#include "peer.h"

enum { SWEEP = 301, EVERY = 30, CYCLES = 400, TRANSIENT = 300, CYCLES_PEER = 20, TURNS = 3 };

static double frequency_of(size_t i) {
    return 20 + (double)i;
}

/* Returns cycles per second. */
static double measure_lanes(const Rig *rig) {
    LanesRun *runs = memory_zeroed(SWEEP, sizeof *runs);
    double seconds[TURNS];
    for (int turn = 0; turn < TURNS; turn++) {
        for (size_t i = 0; i < SWEEP; i++)
            runs[i] = (LanesRun){.frequency = frequency_of(i),
                                 .force = rig->force,
                                 .clearance = rig->clearance,
                                 .transient_cycles = TRANSIENT,
                                 .cycles = CYCLES - TRANSIENT};
        double begin = bench_now();
        lanes_run(rig, runs, SWEEP, NULL);
        seconds[turn] = bench_now() - begin;
    }
    memory_free(runs);
    return SWEEP * CYCLES / bench_median(seconds, TURNS);
}

/* Returns cycles per second over all frequencies, each weighted by its time as in the sweep. */
static void measure_peer(const Rig *rig, double tolerance, double exact) {
    double start[8] = {0}, seconds = 0;
    size_t cycles = 0;
    for (size_t i = 0; i < SWEEP; i += EVERY) {
        Rig own = rig_share(rig, frequency_of(i), rig->force, rig->clearance);
        Peer *peer = peer_create(&own, start, tolerance);
        double begin = bench_now();
        for (int k = 0; k < CYCLES_PEER; k++)
            peer_cycle(peer);
        seconds += bench_now() - begin;
        cycles += CYCLES_PEER;
        peer_destroy(peer);
        rig_clear_shared(&own);
    }
    double rate = (double)cycles / seconds;
    printf("CVODE, rtol %.0e  %8.0f cycles/s  lanes make %.0f times as many\n", tolerance, rate, exact / rate);
}

int main(int argc, char **argv) {
    if (argc < 2)
        return 2;
    char path[4096];
    const char *modes = "beam.modes=4";
    Beam beam = {0};
    Fault fault = {0};
    Rig rig;
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", argv[1]);
    if (!beam_read(&beam, path, &modes, 1, &fault) || !rig_build(&rig, &beam, path, &fault)) {
        printf("%s\n", fault.lines[0]);
        return 1;
    }
    double exact = measure_lanes(&rig);
    printf("lanes, exact      %8.0f cycles/s\n", exact);
    measure_peer(&rig, 1e-6, exact);
    measure_peer(&rig, 1e-9, exact);
    rig_clear(&rig);
    beam_free(&beam);
    return 0;
}
