#include "beam/lanes.h"

#include <string.h>

/* The cycle that has just been made. */
static void note_cycle(LanesRun *run, Motion *motion) {
    size_t at = run->recorded++, states = motion->rig->free.states;
    if (run->peak)
        memcpy(run->peak + 2 * at, motion->peak, sizeof motion->peak);
    if (run->deflection)
        run->deflection[at] = motion_deflection(motion);
    if (run->velocity)
        run->velocity[at] = motion_velocity(motion);
    if (run->section)
        motion_state(motion, run->section + at * states);
}

static void make_run(const Rig *rig, LanesRun *run, const volatile sig_atomic_t *stop) {
    Rig own = rig_share(rig, run->frequency, run->force, run->clearance);
    Motion motion = motion_create(&own, 0);
    if (run->start)
        motion_set_state(&motion, run->start);
    run->recorded = 0;
    for (int i = 0; i < run->transient_cycles + run->cycles && !(stop && *stop); i++) {
        motion.peak[0] = motion.peak[1] = 0;
        if (motion_cycle(&motion) != MOTION_GOOD)
            break;
        if (i >= run->transient_cycles)
            note_cycle(run, &motion);
    }
    run->status = motion.status;
    if (run->end)
        motion_state(&motion, run->end);
    motion_destroy(&motion);
    rig_clear_shared(&own);
}

void lanes_run(const Rig *rig, LanesRun *runs, size_t count, const volatile sig_atomic_t *stop) {
    for (size_t i = 0; i < count; i++)
        make_run(rig, &runs[i], stop);
}
