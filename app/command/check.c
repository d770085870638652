#include <stdio.h>

#include "base/text.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/progress.h"
#include "command/suggestions.h"
#include "house/journey.h"
#include "plan/overlap.h"
#include "result/census.h"

/* Returns the id of the exit, also where there is only one; NULL if the person takes the quickest. */
static const char *exit_name(const House *house, size_t exit) {
    const Plan *plan = &house->plan;
    return exit < plan->exit_count ? plan->exits[exit].id : plan->exit_count == 1 ? plan->exits[0].id : NULL;
}

/* Returns the answer for a person. People on foot follow a field to the nearest exit: they have no planned path, and
 * so no numbers of one. */
static json_t *check_person(const House *house, size_t i, const Route *route) {
    const Inhabitant *person = &house->people[i];
    bool walks = census_walks(person->profile);
    json_t *answer = json_pack("{s:s, s:s, s:s?, s:s?, s:b, s:b, s:o, s:o}", "id", person->id, "profile",
                               person->profile->name, "route", person->route ? person->route->id : NULL, "exit",
                               exit_name(house, route->exit), "fits", route->fits, "drivable", route->drivable,
                               "reversals", walks ? json_null() : json_integer(route->reversals), "path_length",
                               walks ? json_null() : json_real(route->length));
    if (route->answer == ROUTE_FOUND && !walks)
        json_object_set_new(answer, "narrowest",
                            json_pack("{s:f, s:f, s:f}", "x", route->narrowest_at.x, "y", route->narrowest_at.y,
                                      "clearance", route->narrowest));
    else if (route->answer == ROUTE_CANNOT_PASS)
        json_object_set_new(answer, "blocked_at", answer_blockage(&route->blockage));
    return answer;
}

/* "cannot pass door d2 at (1.00, 2.00): needs at least 0.80 m, has 0.75 m"; is it the width that stops somebody? */
static bool print_blockage(const Blockage *blockage) {
    char widths[64];
    route_widths(blockage, widths, sizeof widths);
    printf("cannot pass %s at (%.2f, %.2f)%s%s", blockage->what, blockage->at.x, blockage->at.y, *widths ? ": " : "",
           widths);
    return *widths;
}

static void print_person(const House *house, size_t i, const Route *route) {
    const Inhabitant *person = &house->people[i];
    const char *exit = exit_name(house, route->exit);
    bool walks = census_walks(person->profile);
    printf("%s (%s%s%s): ", person->id, person->profile->name, person->route ? ", route " : "",
           person->route ? person->route->id : "");
    if (route->answer == ROUTE_NO_EXIT) {
        printf("no exit");
    } else if (route->answer == ROUTE_CANNOT_PASS) {
        if (print_blockage(&route->blockage) && !walks)
            printf("; it %s", route->fits ? "fits, but cannot be driven" : "does not fit");
    } else if (walks) {
        printf("gets out%s%s", exit ? " by " : "", exit ? exit : "");
    } else {
        printf("gets out by %s, %.1f m, %d changes of direction, narrowest %.3f m at (%.2f, %.2f)", exit, route->length,
               route->reversals, route->narrowest, route->narrowest_at.x, route->narrowest_at.y);
    }
    printf("\n");
}

/* Returns an observation in which each person with a route has completed it, for the census. */
static Observation observation_of_routes(const House *house, const Journeys *journeys) {
    static const Reason reasons[] = {
        [ROUTE_FOUND] = REASON_NONE, [ROUTE_CANNOT_PASS] = REASON_CANNOT_PASS, [ROUTE_NO_EXIT] = REASON_NO_EXIT};
    Observation observation = {
        .people = memory_zeroed(house->person_count, sizeof *observation.people),
        .person_count = house->person_count,
    };
    for (size_t i = 0; i < house->person_count; i++) {
        const Route *route = &journeys->of[i].route;
        observation.people[i] = (PersonObservation){.took_part = true,
                                                    .completed = route->answer == ROUTE_FOUND,
                                                    .reason = reasons[route->answer],
                                                    .exit = route->exit,
                                                    .blockage = route->blockage};
    }
    return observation;
}

/* Returns the first person of a party who does not get out, or person_count. */
static size_t first_stuck(const House *house, const Observation *observation, const Census *census, size_t party) {
    size_t i = census->parties[party].first;
    while (i < house->person_count && (census->party_of[i] != party || observation->people[i].completed))
        i++;
    return i;
}

static void print_party(const House *house, const Observation *observation, const Census *census, size_t p) {
    const Party *party = &census->parties[p];
    size_t stuck = first_stuck(house, observation, census, p);
    printf("%s (%s%s%s), %zu people: ", census_party_name(house, party), party->profile->name,
           party->route ? ", route " : "", party->route ? party->route->id : "", party->people);
    if (stuck == house->person_count) {
        printf("all get out\n");
        return;
    }
    const PersonObservation *first = &observation->people[stuck];
    if (party->out)
        printf("%zu do not get out, the first, %s: ", party->people - party->out, house->people[stuck].id);
    else
        printf("nobody gets out: ");
    if (first->reason == REASON_CANNOT_PASS)
        print_blockage(&first->blockage);
    else
        printf("%s", observation_reason(first->reason));
    printf("\n");
}

/* Prints a line per person; with many people a line per crowd, and one per person without a crowd. */
static void print_answer(const House *house, const Journeys *journeys) {
    Observation observation = observation_of_routes(house, journeys);
    Census census = census_make(house, &observation);
    bool many = census.people > CENSUS_ROWS;
    for (size_t p = 0; p < census.party_count && many; p++)
        if (census.parties[p].people > 1)
            print_party(house, &observation, &census, p);
    for (size_t i = 0; i < house->person_count; i++)
        if (!many || census.parties[census.party_of[i]].people == 1)
            print_person(house, i, &journeys->of[i].route);
    if (!house->person_count)
        printf("no errors; the house has no people\n");
    census_clear(&census);
    observation_free(&observation);
}

/* Returns notes about things that are allowed but strange. */
static json_t *notes_of(const Plan *plan) {
    json_t *notes = json_array();
    for (size_t f = 0; f < plan->furniture_count; f++) {
        char name[80], note[160];
        size_t wall = 0;
        double depth = overlap_depth(plan, &plan->furniture[f], &wall);
        if (depth < OVERLAP_LEAST)
            continue;
        outline_name(plan, OWNER_FURNITURE, (int)f, name, sizeof name);
        snprintf(note, sizeof note, "%s stands %.0f cm in wall %s", name, 100 * depth, plan->walls[wall].id);
        text_make_plain(note);
        json_array_append_new(notes, json_string(note));
    }
    return notes;
}

static void print_notes(const json_t *notes) {
    for (size_t i = 0; i < json_array_size(notes); i++)
        printf("note: %s\n", json_string_value(json_array_get(notes, i)));
}

static json_t *fault_lines(const Fault *fault) {
    json_t *lines = json_array();
    for (size_t i = 0; i < fault->count; i++)
        json_array_append_new(lines, json_string(fault->lines[i]));
    return lines;
}

/* Adds the smallest changes to the answer, or prints them. */
static bool suggest(const Options *options, json_t *answer, Fault *fault) {
    SuggestList list = {0};
    fflush(stdout);
    if (!suggestions_find(&list, options, fault))
        return false;
    suggestions_add(answer, &list);
    if (!options->json)
        suggestions_print(&list);
    suggest_clear(&list);
    return true;
}

int command_check(const Options *options) {
    House house = {0};
    Fault fault = {0};
    if (!house_file_read(&house, options, 0, &fault)) {
        if (options->json)
            answer_print(json_pack("{s:s, s:o, s:[]}", "kind", "check", "faults", fault_lines(&fault), "people"));
        return house_file_report(&fault);
    }
    Journeys journeys = journey_plan_all(&house, NULL, options->jobs, &progress_interrupted);
    json_t *people = json_array();
    bool all = true;
    for (size_t i = 0; i < house.person_count; i++) {
        const Route *route = &journeys.of[i].route;
        all &= route->answer == ROUTE_FOUND;
        json_array_append_new(people, check_person(&house, i, route));
    }
    json_t *notes = notes_of(&house.plan);
    json_t *answer = json_pack("{s:s, s:[], s:o, s:o}", "kind", "check", "faults", "notes", notes, "people", people);
    if (!options->json) {
        print_answer(&house, &journeys);
        print_notes(notes);
    }
    bool good = !options->suggest || suggest(options, answer, &fault);
    if (options->json && good)
        answer_print(json_incref(answer));
    json_decref(answer);
    journey_free_all(&journeys);
    house_free(&house);
    return !good ? house_file_report(&fault) : all ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
