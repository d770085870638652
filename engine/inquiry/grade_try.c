#include "inquiry/grade_try.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

/* 1: a body that is grown by 1 all round reaches sqrt(2) at its corners. */
#define CORNER M_SQRT1_2

/* Corrects what is said of a start: a body that is grown there is inside something, the true one stands beside it. */
static void say_beside(char *what) {
    static const char inside[] = "start, inside ";
    if (strncmp(what, inside, sizeof inside - 1) == 0)
        memcpy(what + strlen("start, "), "beside", strlen("beside"));
}

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
                      .reversals = route->reversals,
                      .blocked = route->answer == ROUTE_CANNOT_PASS && *route->blockage.what,
                      .weak = route->answer == ROUTE_TOO_WEAK,
                      .blockage = route->blockage};
    if (growth > 0)
        say_beside(tried.blockage.what);
    journey_free_all(&journeys);
    memory_free(part);
    memory_free(grown.people);
    return tried;
}
