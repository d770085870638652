#include "house/journey.h"

#include <stdint.h>

#include "base/memory.h"
#include "base/parallel.h"

typedef struct Planning {
    const House *house;
    const bool *part;
    const volatile sig_atomic_t *stop;
    Journey *journeys;
    Fields *fields; /* shared by all */
} Planning;

static void plan_journey(void *context, size_t i) {
    Planning *planning = context;
    const House *house = planning->house;
    const Inhabitant *person = &house->people[i];
    Journey *journey = &planning->journeys[i];
    if (planning->part && !planning->part[i])
        return;
    RouteQuery query = {.plan = &house->plan,
                        .space = &house->space,
                        .profile = person->profile,
                        .at = person->at,
                        .heading = person->heading,
                        .via = person->route ? person->route->via.at : NULL,
                        .via_count = person->route ? person->route->via.count : 0,
                        .exit = person->route ? person->route->exit_index : SIZE_MAX,
                        .time = person->delay,
                        .most_reversals = house->plan.run.reversals,
                        .stop = planning->stop,
                        .fields = planning->fields};
    bool miura = person->profile->driving == DRIVING_MIURA;
    journey->route = miura ? route_round(&query) : route_drive(&query);
    if (journey->route.answer != ROUTE_FOUND)
        return;
    if (miura)
        track_build_miura(&journey->track, house, person, &journey->route);
    else
        track_build_driver(&journey->track, house, person, &journey->route);
}

Journey *journey_plan_all(const House *house, const bool *part, int jobs, const volatile sig_atomic_t *stop) {
    Journey *journeys = memory_allocate(house->person_count, sizeof *journeys);
    Planning planning = {house, part, stop, journeys, fields_create()};
    parallel_for(jobs, house->person_count, plan_journey, &planning);
    fields_destroy(planning.fields);
    return journeys;
}

void journey_free_all(Journey *journeys, size_t count) {
    for (size_t i = 0; i < count; i++) {
        route_free(&journeys[i].route);
        track_free(&journeys[i].track);
    }
    memory_free(journeys);
}
