#include "cycle/cycle.h"

CycleMotion cycle_create(Cycle cycle, size_t tangents) {
    CycleMotion motion = {cycle, cycle.kind->create(cycle.given, tangents), cycle_states(cycle), tangents};
    cycle.kind->unit_tangents(motion.own);
    return motion;
}

void cycle_destroy(CycleMotion *motion) {
    motion->cycle.kind->destroy(motion->own);
    *motion = (CycleMotion){0};
}
