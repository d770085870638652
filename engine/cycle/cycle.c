#include "cycle/cycle.h"

CycleMotion cycle_create(Cycle cycle, size_t tangents, const Stop *stop) {
    CycleMotion motion = {cycle, cycle.kind->create(cycle.given, tangents, stop), cycle_states(cycle), tangents};
    cycle.kind->unit_tangents(motion.own);
    return motion;
}

void cycle_destroy(CycleMotion *motion) {
    motion->cycle.kind->destroy(motion->own);
    *motion = (CycleMotion){0};
}

/* Records the cycle that has just ended. */
static void note_cycle(CycleRun *run, CycleMotion *motion) {
    const CycleKind *kind = motion->cycle.kind;
    double tip[2], *peak = kind->peaks(motion->own);
    kind->tip(motion->own, tip);
    run->deflection[run->recorded] = tip[0];
    run->velocity[run->recorded] = tip[1];
    for (size_t side = 0; side < CYCLE_SIDES; side++) {
        run->peak[CYCLE_SIDES * run->recorded + side] = peak[side];
        peak[side] = 0;
    }
    run->recorded++;
}

void cycle_many(Cycle cycle, CycleRun *runs, size_t count, const Stop *stop) {
    if (cycle.kind->many) {
        cycle.kind->many(cycle.given, runs, count, stop);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        CycleRun *run = &runs[i];
        CycleMotion motion = cycle_create(cycle, 0, stop);
        cycle.kind->set_state(motion.own, run->start);
        run->recorded = 0;
        while (run->recorded < run->cycles && cycle_status(&motion) == CYCLE_GOOD && !stop_requested(stop))
            if (cycle_run(&motion) == CYCLE_GOOD)
                note_cycle(run, &motion);
        run->status = cycle_status(&motion);
        cycle.kind->state(motion.own, run->end);
        cycle_destroy(&motion);
    }
}
