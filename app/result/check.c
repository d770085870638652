#include "result/check.h"

#include <stdint.h>

#include "base/text.h"
#include "result/headline.h"
#include "result/house.h"

/* Returns the id of the exit, also where there is only one; NULL if the person takes the quickest. */
static const char *exit_name(const House *house, size_t exit) {
    const Plan *plan = &house->plan;
    return exit < plan->exit_count ? plan->exits[exit].id : plan->exit_count == 1 ? plan->exits[0].id : NULL;
}

static const char *place(ResultTable *table, Vec2 at) {
    return text_in_arena(&table->arena, "(%.2f, %.2f)", at.x, at.y);
}

static void add_blockage(ResultTable *table, const Blockage *blockage) {
    result_house_add_blockage(table, blockage);
    result_add(table, (ResultRow){.label = "stopped at the point",
                                  .head = "at",
                                  .text = blockage ? place(table, blockage->at) : NULL,
                                  .unit = "m"});
}

/* People ---------------------------------------------------------------------------------------------------------- */

static const char *result_of(const Route *route) {
    return route->answer == ROUTE_FOUND ? "can leave" : observation_reason(observation_reason_of(route->answer));
}

/* A body that fits through everything can still be unable to turn there. */
static void add_passing(ResultTable *table, const Route *route, bool walks) {
    const Blockage *blockage = &route->blockage;
    bool interrupted = route->answer == ROUTE_INTERRUPTED;
    bool told = route->answer == ROUTE_CANNOT_PASS && !walks && blockage->has > 0 && blockage->needs > blockage->has;
    result_add(table, (ResultRow){.key = "fits",
                                  .label = "fits",
                                  .kind = RESULT_FLAG,
                                  .number = route->fits,
                                  .unknown = !told,
                                  .omitted = interrupted});
    result_add(table, (ResultRow){.key = "drivable",
                                  .label = "can be driven",
                                  .kind = RESULT_FLAG,
                                  .number = route->drivable,
                                  .unknown = !told,
                                  .omitted = interrupted});
}

static void add_path(ResultTable *table, const Route *route, bool walks) {
    bool found = route->answer == ROUTE_FOUND && !walks, interrupted = route->answer == ROUTE_INTERRUPTED;
    result_add(table, (ResultRow){.key = "reversals",
                                  .label = "changes of direction",
                                  .head = "reversals",
                                  .kind = RESULT_COUNT,
                                  .number = walks ? NAN : route->reversals,
                                  .unknown = !found,
                                  .omitted = interrupted});
    result_add(table, (ResultRow){.key = "path_length",
                                  .label = "path length",
                                  .head = "path",
                                  .kind = RESULT_NUMBER,
                                  .number = walks ? NAN : route->length,
                                  .unit = "m",
                                  .decimals = 2,
                                  .unknown = !found,
                                  .omitted = interrupted});
    result_add(
        table,
        (ResultRow){.key = "narrowest.x", .kind = RESULT_NUMBER, .number = route->narrowest_at.x, .omitted = !found});
    result_add(
        table,
        (ResultRow){.key = "narrowest.y", .kind = RESULT_NUMBER, .number = route->narrowest_at.y, .omitted = !found});
    result_add(table, (ResultRow){.key = "narrowest.clearance",
                                  .label = "narrowest planned clearance",
                                  .head = "narrowest planned",
                                  .kind = RESULT_NUMBER,
                                  .number = route->narrowest,
                                  .unit = "m",
                                  .decimals = 3,
                                  .omitted = !found});
    result_add(
        table,
        (ResultRow){.label = "narrowest at", .text = found ? place(table, route->narrowest_at) : NULL, .unit = "m"});
}

static void add_person(ResultTable *table, const House *house, size_t i, const Route *route) {
    const Inhabitant *person = &house->people[i];
    bool walks = census_walks(person->profile);
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = person->id});
    result_add(table, (ResultRow){.key = "profile", .label = "profile", .text = person->profile->name});
    result_add(table, (ResultRow){.key = "route", .label = "route", .text = person->route ? person->route->id : NULL});
    result_add(table, (ResultRow){.key = "exit", .label = "exit", .text = exit_name(house, route->exit)});
    result_add(table, (ResultRow){.label = "result",
                                  .text = result_of(route),
                                  .role = route->answer == ROUTE_FOUND ? ROLE_TEXT : ROLE_ERROR});
    result_add(table, (ResultRow){.key = "interrupted",
                                  .kind = RESULT_FLAG,
                                  .number = 1,
                                  .omitted = route->answer != ROUTE_INTERRUPTED});
    add_passing(table, route, walks);
    add_path(table, route, walks);
    add_blockage(table, observation_reason_is_planned(observation_reason_of(route->answer)) ? &route->blockage : NULL);
    result_end(table);
}

ResultTable result_check_people(const House *house, const Journeys *journeys, const Census *only_single) {
    ResultTable table = {.numbers = RESULT_REAL};
    for (size_t i = 0; i < house->person_count; i++)
        if (!only_single || only_single->parties[only_single->party_of[i]].people == 1)
            add_person(&table, house, i, &journeys->of[i].route);
    return table;
}

/* Parties --------------------------------------------------------------------------------------------------------- */

Observation result_check_observation(const House *house, const Journeys *journeys) {
    Observation observation = {
        .people = memory_zeroed(house->person_count, sizeof *observation.people),
        .person_count = house->person_count,
    };
    for (size_t i = 0; i < house->person_count; i++) {
        const Route *route = &journeys->of[i].route;
        observation.interrupted |= route->answer == ROUTE_INTERRUPTED;
        observation.people[i] = (PersonObservation){.took_part = true,
                                                    .completed = route->answer == ROUTE_FOUND,
                                                    .reason = observation_reason_of(route->answer),
                                                    .exit = route->exit,
                                                    .blockage = route->blockage};
    }
    return observation;
}

/* Returns the first person of a party who cannot leave, or person_count. */
static size_t first_stuck(const House *house, const Observation *observation, const Census *census, size_t party) {
    size_t i = census->parties[party].first;
    while (i < house->person_count && (census->party_of[i] != party || observation->people[i].completed))
        i++;
    return i;
}

static void add_party(ResultTable *table, const House *house, const Observation *observation, const Census *census,
                      size_t p) {
    const Party *party = &census->parties[p];
    size_t stuck = first_stuck(house, observation, census, p);
    const PersonObservation *first = stuck < house->person_count ? &observation->people[stuck] : NULL;
    result_add(table, (ResultRow){.label = "people", .text = census_party_name(house, party)});
    result_add(table, (ResultRow){.label = "profile", .text = party->profile->name});
    result_add(table, (ResultRow){.label = "route", .text = party->route ? party->route->id : NULL});
    result_add(table, (ResultRow){.label = "number", .kind = RESULT_COUNT, .number = (double)party->people});
    result_add(table, (ResultRow){.label = "can leave", .kind = RESULT_COUNT, .number = (double)party->out});
    result_add(table, (ResultRow){.label = "first who cannot leave", .text = first ? house->people[stuck].id : NULL});
    result_add(
        table,
        (ResultRow){.label = "result", .text = first ? observation_reason(first->reason) : NULL, .role = ROLE_ERROR});
    add_blockage(table, first && observation_reason_is_planned(first->reason) ? &first->blockage : NULL);
    result_end(table);
}

ResultTable result_check_parties(const House *house, const Observation *observation, const Census *census) {
    ResultTable table = {0};
    for (size_t p = 0; p < census->party_count; p++)
        if (census->parties[p].people > 1)
            add_party(&table, house, observation, census, p);
    return table;
}

/* Grades ----------------------------------------------------------------------------------------------------------- */

static void add_grade(ResultTable *table, const House *house, size_t i, const Grade *grade) {
    Arena *arena = &table->arena;
    const char *letter = grade_letter(grade->letter), *words = grade_words(grade->letter);
    bool known = isfinite(grade->tightness), best = grade->letter == GRADE_A;
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = house->people[i].id});
    result_add(table, (ResultRow){.key = "grade", .text = letter});
    result_add(table,
               (ResultRow){.key = "said", .label = "grade", .text = text_in_arena(arena, "%s, %s", letter, words)});
    result_add(table,
               (ResultRow){.key = "tightness",
                           .label = "room to spare on each side",
                           .head = "to spare",
                           .kind = RESULT_NUMBER,
                           .number = grade->tightness,
                           .unit = "cm",
                           .factor = 100,
                           .decimals = 1,
                           .text = grade->wider ? text_in_arena(arena, "%.1f or more", 100 * grade->tightness) : NULL,
                           .omitted = !known});
    result_add(table, (ResultRow){.key = "to_next",
                                  .label = "to the next grade, on each side",
                                  .head = "to the next grade",
                                  .kind = RESULT_NUMBER,
                                  .number = grade->to_next,
                                  .unit = "cm",
                                  .factor = 100,
                                  .decimals = 1,
                                  .unknown = best,
                                  .omitted = !isfinite(grade->to_next)});
    result_add(table, (ResultRow){.key = "weak", .kind = RESULT_FLAG, .number = 1, .omitted = !grade->weak});
    const char *at = grade->has_place ? grade->what : NULL;
    result_add(table, (ResultRow){.key = "what", .text = at, .omitted = !at});
    result_add(table, (ResultRow){.label = "tightest at",
                                  .text = grade->weak ? text_in_arena(arena, "too weak: %s", grade->what) : at});
    result_add(table,
               (ResultRow){.key = "x", .kind = RESULT_NUMBER, .number = grade->at.x, .omitted = !grade->has_place});
    result_add(table,
               (ResultRow){.key = "y", .kind = RESULT_NUMBER, .number = grade->at.y, .omitted = !grade->has_place});
    result_add(table,
               (ResultRow){.label = "at", .text = grade->has_place ? place(table, grade->at) : NULL, .unit = "m"});
    result_end(table);
}

ResultTable result_check_grades(const House *house, const Grade *grades) {
    ResultTable table = {.numbers = RESULT_REAL};
    for (size_t i = 0; i < house->person_count; i++)
        if (house->people[i].profile->driving == DRIVING_DRIVER && !grades[i].interrupted)
            add_grade(&table, house, i, &grades[i]);
    return table;
}

static void add_grade_place(ResultTable *table, const House *house, size_t i, const GradePlace *of) {
    const char *next = of->letter > GRADE_D ? grade_letter(GRADE_D) : grade_letter(of->letter - 1);
    const char *change = of->changes ? text_in_arena(&table->arena, "%s", of->change) : NULL;
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = house->people[i].id});
    result_add(table, (ResultRow){.key = "what", .label = "place", .text = of->what});
    result_add(table, (ResultRow){.label = "at", .text = place(table, of->at), .unit = "m"});
    result_add(table, (ResultRow){.key = "x", .kind = RESULT_NUMBER, .number = of->at.x});
    result_add(table, (ResultRow){.key = "y", .kind = RESULT_NUMBER, .number = of->at.y});
    result_add(table, (ResultRow){.key = "grade", .label = "grade", .text = grade_letter(of->letter)});
    result_add(table, (ResultRow){.key = "to_next",
                                  .label = "missing on each side",
                                  .head = "missing",
                                  .kind = RESULT_NUMBER,
                                  .number = of->to_next,
                                  .unit = "cm",
                                  .factor = 100,
                                  .decimals = 1,
                                  .omitted = !isfinite(of->to_next)});
    result_add(table, (ResultRow){.key = "next", .label = "for grade", .text = next});
    result_add(table, (ResultRow){.key = "change.size", .kind = RESULT_NUMBER, .number = of->by, .omitted = !change});
    result_add(table, (ResultRow){.key = "change.text", .text = change, .omitted = !change});
    result_add(table, (ResultRow){.label = "the change that buys it",
                                  .text = change ? change : "no door or piece nearby is enough"});
    result_end(table);
}

ResultTable result_check_grade_places(const House *house, const Grade *grades) {
    ResultTable table = {.numbers = RESULT_REAL};
    for (size_t i = 0; i < house->person_count; i++)
        for (size_t p = 0; house->people[i].profile->driving == DRIVING_DRIVER && p < grades[i].place_count; p++)
            add_grade_place(&table, house, i, &grades[i].places[p]);
    return table;
}

/* The sentence ---------------------------------------------------------------------------------------------------- */

const char *result_check_sentence(const House *house, const Observation *observation, const Census *census,
                                  Arena *arena) {
    char reasons[512];
    if (!census->people)
        return "The house has no errors and no people";
    if (census->stuck == SIZE_MAX && census->people > 1)
        return text_in_arena(arena, "All %zu people can leave", census->people);
    if (census->stuck == SIZE_MAX) {
        const char *exit = exit_name(house, observation->people[0].exit), *id = house->people[0].id;
        return exit ? text_in_arena(arena, "%s can leave by %s", id, exit) : text_in_arena(arena, "%s can leave", id);
    }
    if (observation->interrupted)
        return text_in_arena(arena, "The check was interrupted: of %zu people, %zu can leave so far", census->people,
                             census->out);
    if (census->people == 1)
        return headline_make(house, observation, census, arena).sentence;
    census_reasons(house, census, true, reasons, sizeof reasons);
    return text_in_arena(arena, "%zu of %zu cannot leave: %s", census->people - census->out, census->people, reasons);
}
