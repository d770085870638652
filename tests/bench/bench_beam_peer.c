/* The impact beam of 4 modes at 300 Hz on one core, exactly and by CVODE (Adams, root-finding) in one process. */

#include <stdio.h>

#include "bench.h"
#include "peer.h"

enum { CYCLES_EXACT = 5000, CYCLES_PEER = 300 };

static void measure_peer(const Rig *rig, const double *start, double tolerance, double exact) {
    Peer *peer = peer_create(rig, start, tolerance);
    double begin = bench_now();
    for (int i = 0; i < CYCLES_PEER; i++)
        peer_cycle(peer);
    double rate = CYCLES_PEER / (bench_now() - begin);
    printf("CVODE, rtol %.0e  %8.0f cycles/s  the exact motion makes %.0f times as many\n", tolerance, rate,
           exact / rate);
    peer_destroy(peer);
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
    double start[8] = {0}, begin = bench_now();
    Motion motion = motion_create(&rig, 0);
    for (int i = 0; i < CYCLES_EXACT; i++)
        motion_cycle(&motion);
    double exact = CYCLES_EXACT / (bench_now() - begin);
    printf("exact             %8.0f cycles/s\n", exact);
    measure_peer(&rig, start, 1e-6, exact);
    measure_peer(&rig, start, 1e-9, exact);
    motion_destroy(&motion);
    rig_clear(&rig);
    beam_free(&beam);
    return 0;
}
