#include "house/observation.h"

#include <stdint.h>

#include "base/memory.h"

const TraceColumn observation_columns[TRACE_COLUMNS] = {
    {"time", "s"},    {"person", "1"},        {"x", "m"},         {"y", "m"},          {"heading", "rad"},
    {"speed", "m/s"}, {"clearance", "m"},     {"ring", "m"},      {"body_force", "N"}, {"ring_force", "N"},
    {"offset", "m"},  {"offset_rate", "m/s"}, {"contact_x", "m"}, {"contact_y", "m"},
};

const char *observation_reason(Reason reason) {
    static const char *const texts[] = {"",           "cannot pass", "no exit",     "blocked",
                                        "time limit", "diverged",    "interrupted", "another person diverged"};
    return texts[reason];
}

Reason observation_reason_of(RouteAnswer answer) {
    switch (answer) {
    case ROUTE_FOUND:
        return REASON_NONE;
    case ROUTE_CANNOT_PASS:
        return REASON_CANNOT_PASS;
    case ROUTE_NO_EXIT:
        return REASON_NO_EXIT;
    case ROUTE_INTERRUPTED:
        return REASON_INTERRUPTED;
    }
    return REASON_INTERRUPTED;
}

void observation_free(Observation *observation) {
    memory_free(observation->people);
    memory_free(observation->hazards);
    memory_free(observation->door_opened);
    memory_free(observation->mixed);
    trace_clear(&observation->trace);
    *observation = (Observation){0};
}

const PersonObservation *observation_of_person(const House *house, const Observation *observation, const char *id) {
    size_t i = house_find_person(house, id);
    return i == SIZE_MAX ? NULL : &observation->people[i];
}
