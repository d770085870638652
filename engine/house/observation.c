#include "house/observation.h"

#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "plan/overlap.h"

static const double SPECK = 0.02; /* m, of the middle of an exit */

const TraceColumn observation_columns[TRACE_COLUMNS] = {
    {"time", "s"},    {"person", "1"},        {"x", "m"},         {"y", "m"},          {"heading", "rad"},
    {"speed", "m/s"}, {"clearance", "m"},     {"ring", "m"},      {"body_force", "N"}, {"ring_force", "N"},
    {"offset", "m"},  {"offset_rate", "m/s"}, {"contact_x", "m"}, {"contact_y", "m"},
};

const char *observation_reason(Reason reason) {
    static const char *const texts[] = {"",         "cannot pass", "no exit",
                                        "too weak", "blocked",     "time limit",
                                        "diverged", "interrupted", "another person diverged"};
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
    case ROUTE_TOO_WEAK:
        return REASON_TOO_WEAK;
    case ROUTE_INTERRUPTED:
        return REASON_INTERRUPTED;
    }
    return REASON_INTERRUPTED;
}

bool observation_reason_is_planned(Reason reason) {
    return reason == REASON_CANNOT_PASS || reason == REASON_TOO_WEAK;
}

bool observation_reason_has_place(Reason reason) {
    return observation_reason_is_planned(reason) || reason == REASON_BLOCKED;
}

void observation_free(Observation *observation) {
    memory_free(observation->people);
    memory_free(observation->hazards);
    memory_free(observation->touches);
    memory_free(observation->door_opened);
    memory_free(observation->mixed);
    trace_clear(&observation->trace);
    *observation = (Observation){0};
}

const PersonObservation *observation_of_person(const House *house, const Observation *observation, const char *id) {
    size_t i = house_find_person(house, id);
    return i == SIZE_MAX ? NULL : &observation->people[i];
}

/* Exits on walls --------------------------------------------------------------------------------------------------- */

static bool is_closed(const Plan *plan, const Exit *exit, size_t *wall) {
    Furniture middle = {.id = "", .centre = vec2_scale(vec2_add(exit->from, exit->to), 0.5), .topples = TOPPLE_NO};
    middle.size = vec2(SPECK, SPECK);
    return overlap_depth(plan, &middle, wall) > 0;
}

size_t observation_walled_exit(const House *house, const Observation *observation) {
    const Plan *plan = &house->plan;
    size_t wall, first = 0;
    while (first < observation->person_count && observation->people[first].reason != REASON_CANNOT_PASS)
        first++;
    if (first == observation->person_count || strncmp(observation->people[first].blockage.what, "wall ", 5) != 0)
        return SIZE_MAX;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (is_closed(plan, &plan->exits[e], &wall) &&
            strcmp(plan->walls[wall].id, observation->people[first].blockage.what + 5) == 0)
            return e;
    return SIZE_MAX;
}
