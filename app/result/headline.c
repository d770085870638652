#include "result/headline.h"

#include <stdio.h>

#include "result/census.h"

/* Prints "p1 is blocked at door d2 after 18.4 s". */
static void format_stuck(const House *house, const Observation *observation, size_t i, char *text, size_t size) {
    const PersonObservation *person = &observation->people[i];
    const Blockage *blockage = &person->blockage;
    const char *id = house->people[i].id;
    char widths[64];
    route_widths(blockage, widths, sizeof widths);
    if (house->people[i].under)
        snprintf(text, size, "%s is caught %s", id, blockage->what);
    else if (person->reason == REASON_CANNOT_PASS)
        snprintf(text, size, "%s cannot pass %s%s%s", id, blockage->what, *widths ? ": " : "", widths);
    else if (person->reason == REASON_BLOCKED)
        snprintf(text, size, "%s is blocked at %s after %.1f s", id, blockage->what, person->time);
    else
        snprintf(text, size, "%s is not out: %s at %.1f s", id, observation_reason(person->reason), person->time);
}

void headline_text(const House *house, const Observation *observation, char *text, size_t size) {
    Census census = census_make(house, observation);
    size_t stuck = census.people - census.out;
    if (!census.people) {
        snprintf(text, size, "Nobody takes part");
    } else if (!stuck && census.people == 1) {
        snprintf(text, size, "Out in %.1f s", observation->time);
    } else if (!stuck) {
        bool alone = house->plan.run.routes == ROUTES_ALONE && house->plan.route_count > 1;
        snprintf(text, size, alone ? "All %zu out, each route alone, in at most %.1f s" : "All %zu out in %.1f s",
                 census.people, observation->time);
    } else {
        char why[HEADLINE_TEXT / 2], others[64] = "";
        if (census.out)
            snprintf(others, sizeof others,
                     census.out > 1 ? "; the others are out in %.1f s" : "; the other person is out in %.1f s",
                     census.last);
        if (stuck == 1) {
            format_stuck(house, observation, census.stuck, why, sizeof why);
            snprintf(text, size, "%s%s", why, others);
        } else {
            census_reasons(house, &census, true, why, sizeof why);
            snprintf(text, size, "%zu of %zu are not out: %s%s", stuck, census.people, why, others);
        }
    }
    census_clear(&census);
}
