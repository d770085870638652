#include <string.h>

#include "base/memory.h"
#include "base/stop.h"
#include "beam/lanes.h"
#include "check.h"
#include "oscillator.h"

enum { RUNS = 21, TRANSIENT = 30, CYCLES = 20 };

/* Returns the results of a run by a single motion. */
static void run_alone(const Rig *rig, LanesRun *run) {
    Rig own = rig_share(rig, run->frequency, run->force, run->clearance);
    Motion motion = motion_create(&own, 0);
    size_t states = rig->free.states;
    if (run->start)
        motion_set_state(&motion, run->start);
    run->recorded = 0;
    for (int i = 0; i < TRANSIENT + CYCLES && motion.status == CYCLE_GOOD; i++) {
        motion.peak[0] = motion.peak[1] = 0;
        if (motion_cycle(&motion) == CYCLE_GOOD && i >= TRANSIENT) {
            memcpy(run->peak + 2 * run->recorded, motion.peak, sizeof motion.peak);
            motion_state(&motion, run->section + run->recorded++ * states);
        }
    }
    run->status = motion.status;
    motion_destroy(&motion);
    rig_clear_shared(&own);
}

static LanesRun make_run(const Rig *rig, size_t i, double *start) {
    size_t states = rig->free.states;
    oscillator_start(rig, (unsigned)i, start);
    return (LanesRun){.frequency = 20 + 37.7 * (double)i,
                      .force = rig->force * (1 + 0.1 * (double)(i % 3)),
                      .clearance = rig->clearance * (double)(i % 4),
                      .start = i % 2 ? start : NULL,
                      .transient_cycles = TRANSIENT,
                      .cycles = CYCLES,
                      .peak = memory_zeroed(2 * CYCLES, sizeof(double)),
                      .section = memory_zeroed(CYCLES * states, sizeof(double))};
}

static void check_lanes(const char *setting, int release) {
    Rig rig = oscillator_beam_rig("ibs", setting);
    rig.release = release;
    size_t states = rig.free.states, different = 0, touched = 0;
    double *starts = memory_zeroed(RUNS * states, sizeof *starts);
    LanesRun together[RUNS], alone;
    for (size_t i = 0; i < RUNS; i++)
        together[i] = make_run(&rig, i, starts + i * states);
    lanes_run(&rig, together, RUNS, NULL);
    for (size_t i = 0; i < RUNS; i++) {
        alone = make_run(&rig, i, starts + i * states);
        run_alone(&rig, &alone);
        CHECK(alone.recorded == together[i].recorded);
        CHECK(alone.status == together[i].status);
        different += memcmp(alone.section, together[i].section, CYCLES * states * sizeof(double)) != 0;
        different += memcmp(alone.peak, together[i].peak, 2 * CYCLES * sizeof(double)) != 0;
        touched += alone.peak[0] > 0;
        memory_free(alone.peak);
        memory_free(alone.section);
        memory_free(together[i].peak);
        memory_free(together[i].section);
    }
    CHECK_NEAR((double)different, 0, 0);
    CHECK(touched > RUNS / 4);
    memory_free(starts);
    rig_clear(&rig);
}

TEST(a_lane_has_the_bits_of_a_motion_alone) {
    for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++) {
        check_lanes("beam.modes=4", release);
        check_lanes("beam.modes=12", release);
        check_lanes("joint.damping=2e4", release);
        check_lanes("beam.modes=1", release);
    }
}

TEST(lanes_that_are_stopped_say_how_far_they_came) {
    Rig rig = oscillator_beam_rig("ibs", "beam.modes=4");
    Stop stop = {1};
    LanesRun runs[20];
    for (size_t i = 0; i < 20; i++)
        runs[i] =
            (LanesRun){.frequency = 300, .force = 225, .clearance = 1e-4, .transient_cycles = 5, .cycles = 1000000};
    lanes_run(&rig, runs, 20, &stop);
    for (size_t i = 0; i < 20; i++)
        CHECK(runs[i].recorded < 10);
    rig_clear(&rig);
}
