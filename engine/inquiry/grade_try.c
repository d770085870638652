#include "inquiry/grade_try.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

/* 1: a body that is grown by 1 all round reaches sqrt(2) at its corners. */
#define CORNER M_SQRT1_2

GradeTry grade_try_growth(const House *house, size_t person, double growth, int reversals, const Stop *stop) {
    House grown = *house;
    Profile body = *house->people[person].profile;
    body.width += 2 * growth;
    body.length += 2 * growth;
    body.axle += growth;
    grown.plan.run.reversals = reversals;
    grown.people = memory_zeroed(house->person_count, sizeof *grown.people);
    memcpy(grown.people, house->people, house->person_count * sizeof *grown.people);
    grown.people[person].profile = &body;
    bool *part = memory_zeroed(house->person_count, sizeof *part);
    part[person] = true;
    Journeys journeys = journey_plan_any(&grown, part, stop);
    const Route *route = &journeys.of[person].route;
    GradeTry tried = {.found = route->answer == ROUTE_FOUND,
                      .fits = route->fits,
                      .holds = growth + fmax(route->narrowest, 0) * CORNER,
                      .blocked = route->answer == ROUTE_CANNOT_PASS && *route->blockage.what,
                      .weak = route->answer == ROUTE_TOO_WEAK,
                      .blockage = route->blockage};
    journey_free_all(&journeys);
    memory_free(part);
    memory_free(grown.people);
    return tried;
}
