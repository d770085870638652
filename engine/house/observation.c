#include "house/observation.h"

#include "base/memory.h"

const char *observation_reason(Reason reason) {
    static const char *const texts[] = {"",           "cannot pass", "no exit",    "blocked",
                                        "time limit", "diverged",    "interrupted"};
    return texts[reason];
}

void observation_free(Observation *observation) {
    memory_free(observation->people);
    memory_free(observation->hazards);
    memory_free(observation->door_opened);
    trace_clear(&observation->trace);
    *observation = (Observation){0};
}
