#include "house/observation.h"

#include <string.h>

#include "base/memory.h"

const TraceColumn observation_columns[TRACE_COLUMNS] = {
    {"time", "s"},    {"person", "1"},        {"x", "m"},         {"y", "m"},          {"heading", "rad"},
    {"speed", "m/s"}, {"clearance", "m"},     {"ring", "m"},      {"body_force", "N"}, {"ring_force", "N"},
    {"offset", "m"},  {"offset_rate", "m/s"}, {"contact_x", "m"}, {"contact_y", "m"},
};

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

const PersonObservation *observation_of_person(const House *house, const Observation *observation, const char *id) {
    for (size_t i = 0; i < house->person_count; i++)
        if (strcmp(house->people[i].id, id) == 0)
            return &observation->people[i];
    return NULL;
}
