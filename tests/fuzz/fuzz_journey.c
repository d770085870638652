/* The input is a house file: all people plan their way out, with a limit of work. */
#include <math.h>

#include "fuzz_house.h"

static void check_route(const Inhabitant *person, const Route *route) {
    fuzz_expect(route->answer <= ROUTE_INTERRUPTED, "an answer is one of the list");
    if (route->answer == ROUTE_CANNOT_PASS || route->answer == ROUTE_TOO_WEAK) {
        const Blockage *blockage = &route->blockage;
        fuzz_expect(fuzz_house_is_finite(blockage->at), "a blockage is somewhere");
        fuzz_expect(*blockage->what, "a blockage has a name");
        fuzz_expect(isfinite(blockage->has) && isfinite(blockage->needs), "widths are finite");
        fuzz_expect(blockage->has >= 0 && blockage->needs >= 0, "widths are not negative");
    }
    if (route->answer != ROUTE_FOUND)
        return;
    for (size_t p = 0; p < route->count; p++) {
        const Pose *pose = &route->poses[p];
        fuzz_expect(fuzz_house_is_finite(pose->at) && isfinite(pose->heading), "a pose is somewhere");
        fuzz_expect(pose->direction >= -1 && pose->direction <= 1, "a direction is forwards, backwards or a turn");
        fuzz_expect(!isnan(pose->clearance), "a clearance is a number");
    }
    if (route->count)
        fuzz_expect(vec2_length(vec2_sub(route->poses[0].at, person->at)) < 1e-6, "a path begins where the person is");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    House house;
    if (!fuzz_house_read(&house, data, size))
        return 0;
    Stop stop = {0};
    Journeys journeys = fuzz_house_plan(&house, &stop);
    fuzz_expect(journeys.count == house.person_count, "each person has a journey");
    for (size_t i = 0; i < journeys.count; i++) {
        check_route(&house.people[i], &journeys.of[i].route);
        fuzz_expect(stop.requested || journeys.of[i].route.answer != ROUTE_INTERRUPTED,
                    "a route is interrupted only after a request");
    }
    journey_free_all(&journeys);
    house_free(&house);
    return 0;
}
