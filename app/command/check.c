#include <stdint.h>
#include <stdio.h>

#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "house/world.h"

static const char *exit_name(const House *house, size_t exit) {
    return exit < house->plan.exit_count ? house->plan.exits[exit].id : NULL;
}

static json_t *check_person(const House *house, size_t i, const Route *route) {
    const Inhabitant *person = &house->people[i];
    const char *exit = exit_name(house, route->exit);
    json_t *answer =
        json_pack("{s:s, s:s, s:s?, s:s?, s:b, s:b, s:i, s:f}", "id", person->id, "profile", person->profile->name,
                  "route", person->route ? person->route->id : NULL, "exit", exit, "fits", route->fits, "drivable",
                  route->drivable, "reversals", route->reversals, "path_length", route->length);
    if (route->answer == ROUTE_FOUND)
        json_object_set_new(answer, "narrowest",
                            json_pack("{s:f, s:f, s:f}", "x", route->narrowest_at.x, "y", route->narrowest_at.y,
                                      "clearance", route->narrowest));
    else if (route->answer == ROUTE_CANNOT_PASS)
        json_object_set_new(answer, "blocked_at", answer_blockage(&route->blockage));
    return answer;
}

static void print_person(const House *house, size_t i, const Route *route) {
    const Inhabitant *person = &house->people[i];
    const Blockage *blockage = &route->blockage;
    const char *exit = exit_name(house, route->exit);
    char widths[64];
    route_widths(blockage, widths, sizeof widths);
    printf("%s (%s%s%s): ", person->id, person->profile->name, person->route ? ", route " : "",
           person->route ? person->route->id : "");
    if (route->answer == ROUTE_FOUND)
        printf("gets out by %s, %.1f m, %d changes of direction, narrowest %.3f m at (%.2f, %.2f)\n", exit,
               route->length, route->reversals, route->narrowest, route->narrowest_at.x, route->narrowest_at.y);
    else if (route->answer == ROUTE_NO_EXIT)
        printf("no exit\n");
    else
        printf("cannot pass %s at (%.2f, %.2f)%s%s%s\n", blockage->what, blockage->at.x, blockage->at.y,
               *widths ? ": " : "", widths,
               !*widths      ? ""
               : route->fits ? "; it fits, but cannot be driven"
                             : "; it does not fit");
}

static json_t *fault_lines(const Fault *fault) {
    json_t *lines = json_array();
    for (size_t i = 0; i < fault->count; i++)
        json_array_append_new(lines, json_string(fault->lines[i]));
    return lines;
}

int command_check(const Options *options) {
    House house = {0};
    Fault fault = {0};
    if (!house_file_read(&house, options, 0, &fault)) {
        if (options->json)
            answer_print(json_pack("{s:s, s:o, s:[]}", "kind", "check", "faults", fault_lines(&fault), "people"));
        return house_file_report(&fault);
    }
    Journeys journeys = journey_plan_all(&house, NULL, options->jobs, &command_interrupted);
    json_t *people = json_array();
    bool all = true;
    for (size_t i = 0; i < house.person_count; i++) {
        const Route *route = &journeys.of[i].route;
        all &= route->answer == ROUTE_FOUND;
        json_array_append_new(people, check_person(&house, i, route));
        if (!options->json)
            print_person(&house, i, route);
    }
    json_t *answer = json_pack("{s:s, s:[], s:o}", "kind", "check", "faults", "people", people);
    if (options->json)
        answer_print(json_incref(answer));
    else if (!house.person_count)
        printf("no faults; nobody lives here\n");
    json_decref(answer);
    journey_free_all(&journeys);
    house_free(&house);
    return all ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
