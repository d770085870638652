#include "result/rules_drivers.h"

#include <math.h>
#include <stdint.h>

/* Notes who is refused, at the place that refuses most of them. */
static void take_share(Inspection *inspection, const House *house, size_t person, const Shares *share) {
    size_t at = share->refused ? inspection_place(inspection, house, share->what, share->at) : SIZE_MAX;
    for (size_t p = 0; p < inspection->place_count; p++)
        if (inspection->passed_by[p * inspection->person_count + person] || p == at)
            inspection->places[p].drivers += share->drivers;
    if (at != SIZE_MAX)
        inspection->places[at].refused += share->refused;
}

static void take_runs(Inspection *inspection, const House *house, const Drivers *drivers, size_t person) {
    for (size_t k = 0; k < drivers->count; k++) {
        const DriverRun *run = &drivers->runs[k * drivers->person_count + person];
        if (!run->varies)
            continue;
        size_t at = SIZE_MAX;
        if (run->contacts > 0) {
            char what[96];
            outline_place_name(&house->outline, &house->plan, run->impact_at, what, sizeof what);
            at = inspection_place(inspection, house, what, run->impact_at);
        }
        for (size_t p = 0; p < inspection->place_count; p++) {
            RulePlace *place = &inspection->places[p];
            place->out += run->completed && inspection->passed_by[p * inspection->person_count + person];
            place->touching += p == at;
        }
    }
}

/* Keeps the tightest grade of a place. */
static void note_grade(RulePlace *place, int letter, double to_next) {
    bool tighter = letter > place->grade || (letter == place->grade && to_next > place->to_next);
    if (!tighter)
        return;
    place->grade = letter;
    place->to_next = to_next;
}

static void take_grade(Inspection *inspection, const House *house, const Grade *grade) {
    for (size_t g = 0; g < grade->place_count; g++) {
        const GradePlace *of = &grade->places[g];
        size_t at = inspection_place(inspection, house, of->what, of->at);
        if (at != SIZE_MAX)
            note_grade(&inspection->places[at], of->letter, of->to_next);
    }
}

void result_rules_drivers_take(Inspection *inspection, const House *house, const char *population,
                               const Drivers *drivers, const Shares *shares, const Grade *grades) {
    inspection->population = population;
    inspection->driver_count = drivers->count;
    for (size_t i = 0; i < house->person_count; i++) {
        if (shares[i].drivers)
            take_share(inspection, house, i, &shares[i]);
        take_runs(inspection, house, drivers, i);
        if (house->people[i].profile->driving == DRIVING_DRIVER && !grades[i].interrupted)
            take_grade(inspection, house, &grades[i]);
    }
    for (size_t p = 0; p < inspection->place_count; p++) {
        bool passed = false, easy = true;
        for (size_t i = 0; i < house->person_count; i++)
            if (inspection->passed_by[p * inspection->person_count + i]) {
                passed = true;
                easy &= house->people[i].profile->driving == DRIVING_DRIVER && grades[i].letter == GRADE_A;
            }
        if (passed && easy)
            note_grade(&inspection->places[p], GRADE_A, 0);
    }
}
