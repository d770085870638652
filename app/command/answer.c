#include "command/answer.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Six digits behind the point are a micrometre and a microsecond: more would be noise. */
static json_t *rounded(double value) {
    return isfinite(value) ? json_real(round(value * 1e6) / 1e6) : json_null();
}

static void set(json_t *object, const char *key, json_t *value) {
    json_object_set_new(object, key, value);
}

static json_t *exit_id(const House *house, size_t exit) {
    return exit < house->plan.exit_count ? json_string(house->plan.exits[exit].id) : json_null();
}

json_t *answer_blockage(const Blockage *blockage) {
    json_t *answer = json_pack("{s:o, s:o, s:s}", "x", rounded(blockage->at.x), "y", rounded(blockage->at.y), "what",
                               blockage->what);
    if (blockage->has > 0 || blockage->needs > 0) {
        set(answer, "has", rounded(blockage->has));
        set(answer, "needs", rounded(blockage->needs));
    }
    return answer;
}

static json_t *answer_person(const House *house, size_t i, const PersonObservation *person) {
    const Inhabitant *inhabitant = &house->people[i];
    json_t *answer =
        json_pack("{s:s, s:s, s:o, s:o, s:b, s:o}", "id", inhabitant->id, "profile", inhabitant->profile->name, "route",
                  inhabitant->route ? json_string(inhabitant->route->id) : json_null(), "exit",
                  exit_id(house, person->exit), "completed", person->completed, "time", rounded(person->time));
    if (!person->completed) {
        set(answer, "reason", json_string(observation_reason(person->reason)));
        if (person->reason == REASON_CANNOT_PASS || person->reason == REASON_BLOCKED)
            set(answer, "blocked_at", answer_blockage(&person->blockage));
    }
    set(answer, "driving", json_string(profile_driving_name(inhabitant->profile->driving)));
    set(answer, "trace_person", json_integer((json_int_t)i));
    set(answer, "reversals", json_integer(person->reversals));
    set(answer, "path_length", rounded(person->path_length));
    set(answer, "narrowest",
        json_pack("{s:o, s:o, s:o}", "x", rounded(person->narrowest_at.x), "y", rounded(person->narrowest_at.y),
                  "clearance", rounded(person->narrowest)));
    set(answer, "contacts", json_integer(person->contacts));
    set(answer, "peak_force", rounded(person->peak_force));
    set(answer, "impulse", rounded(person->impulse));
    set(answer, "ring_time", rounded(person->ring_time));
    set(answer, "lost_time", rounded(person->lost_time));
    return answer;
}

/* The mean time of a route's people, or less than 0 when somebody did not get out or took no part. */
static double route_time(const House *house, const Observation *observation, const PlanRoute *route) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < house->person_count; i++) {
        if (house->people[i].route != route)
            continue;
        if (!observation->people[i].completed)
            return -1;
        sum += observation->people[i].time;
        count++;
    }
    return count ? sum / (double)count : -1;
}

/* The table of routes: (a) mean of the measured, (b) their deviation, (c) simulation, error ((c) - (a)) / (a). */
static json_t *answer_routes(const House *house, const Observation *observation) {
    json_t *routes = json_array();
    for (size_t r = 0; r < house->plan.route_count; r++) {
        const PlanRoute *route = &house->plan.routes[r];
        const Observed *observed = &route->observed;
        double time = route_time(house, observation, route);
        bool measured = observed->mean > 0;
        json_array_append_new(
            routes, json_pack("{s:s, s:o, s:o, s:o, s:o}", "id", route->id, "mean",
                              measured ? rounded(observed->mean) : json_null(), "deviation",
                              measured ? rounded(observed->deviation) : json_null(), "simulation",
                              time >= 0 ? rounded(time) : json_null(), "error",
                              measured && time >= 0 ? rounded((time - observed->mean) / observed->mean) : json_null()));
    }
    return routes;
}

static json_t *answer_hazards(const Observation *observation) {
    json_t *hazards = json_array();
    for (size_t h = 0; h < observation->hazard_count; h++) {
        const Hazard *hazard = &observation->hazards[h];
        json_array_append_new(hazards,
                              json_pack("{s:o, s:o, s:s, s:o, s:o, s:o, s:o}", "x", rounded(hazard->at.x), "y",
                                        rounded(hazard->at.y), "what", hazard->what, "score", rounded(hazard->score),
                                        "clearance", rounded(hazard->clearance), "peak_force",
                                        rounded(hazard->peak_force), "lost_time", rounded(hazard->lost_time)));
    }
    return hazards;
}

json_t *answer_house(const House *house, const Observation *observation) {
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, observation->digest);
    json_t *people = json_array();
    for (size_t i = 0; i < house->person_count; i++)
        if (observation->people[i].took_part)
            json_array_append_new(people, answer_person(house, i, &observation->people[i]));
    return json_pack("{s:s, s:s, s:s, s:I, s:f, s:I, s:b, s:o, s:o, s:o, s:o, s:s}", "kind", "house", "house",
                     house->plan.name, "note", house->plan.note, "seed", (json_int_t)house->seed, "dt", observation->dt,
                     "steps", (json_int_t)observation->steps, "completed", observation->completed, "time",
                     rounded(observation->time), "people", people, "routes", answer_routes(house, observation),
                     "hazards", answer_hazards(observation), "digest", digest);
}

json_t *answer_difference(const char *id, const PersonObservation *a, const PersonObservation *b) {
    bool both = a->completed && b->completed; /* times and clearances of different ways have no difference */
    return json_pack("{s:s, s:o, s:o, s:i, s:o, s:o}", "id", id, "time", rounded(both ? b->time - a->time : NAN),
                     "narrowest", rounded(both ? b->narrowest - a->narrowest : NAN), "contacts",
                     b->contacts - a->contacts, "peak_force", rounded(b->peak_force - a->peak_force), "lost_time",
                     rounded(both ? b->lost_time - a->lost_time : NAN));
}

void answer_print(json_t *answer) {
    char *text = json_dumps(answer, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    puts(text);
    free(text);
    json_decref(answer);
}

/* Text ----------------------------------------------------------------------------------------------------------------
 */

/* The first who did not get out, or person_count. */
static size_t first_left_behind(const Observation *observation) {
    size_t i = 0;
    while (i < observation->person_count && (!observation->people[i].took_part || observation->people[i].completed))
        i++;
    return i;
}

void answer_headline(const House *house, const Observation *observation, char *text, size_t size) {
    size_t i = first_left_behind(observation), taking_part = 0;
    for (size_t k = 0; k < observation->person_count; k++)
        taking_part += observation->people[k].took_part;
    if (!taking_part) {
        snprintf(text, size, "Nobody takes part");
        return;
    }
    if (i == observation->person_count) {
        bool alone = house->plan.run.routes == ROUTES_ALONE && house->plan.route_count > 1;
        snprintf(text, size, alone ? "Out, each route alone, in at most %.1f s" : "Out in %.1f s", observation->time);
        return;
    }
    const PersonObservation *person = &observation->people[i];
    const Blockage *blockage = &person->blockage;
    const char *id = house->people[i].id;
    char widths[64];
    route_widths(blockage, widths, sizeof widths);
    if (person->reason == REASON_CANNOT_PASS)
        snprintf(text, size, "%s cannot pass %s%s%s", id, blockage->what, *widths ? ": " : "", widths);
    else if (person->reason == REASON_BLOCKED)
        snprintf(text, size, "%s is blocked at %s after %.1f s", id, blockage->what, person->time);
    else
        snprintf(text, size, "%s is not out: %s at %.1f s", id, observation_reason(person->reason), person->time);
}

static void print_people(const House *house, const Observation *observation) {
    printf("%-12s %-16s %-6s %-8s %9s %9s %11s %9s %8s %8s %8s  %s\n", "person", "profile", "route", "exit", "time s",
           "reversals", "narrowest m", "contacts", "peak N", "ring s", "lost s", "answer");
    for (size_t i = 0; i < house->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        const Inhabitant *inhabitant = &house->people[i];
        if (!person->took_part)
            continue;
        printf("%-12s %-16s %-6s %-8s %9.2f %9d %11.3f %9d %8.0f %8.1f %8.1f  %s\n", inhabitant->id,
               inhabitant->profile->name, inhabitant->route ? inhabitant->route->id : "-",
               person->exit < house->plan.exit_count ? house->plan.exits[person->exit].id : "-", person->time,
               person->reversals, person->narrowest, person->contacts, person->peak_force, person->ring_time,
               person->lost_time, person->completed ? "out" : observation_reason(person->reason));
    }
}

static void print_routes(const House *house, const Observation *observation) {
    if (!house->plan.route_count)
        return;
    printf("\n%-6s %12s %14s %15s %16s\n", "route", "mean (a) s", "deviation (b) s", "simulation (c) s",
           "((c)-(a))/(a)");
    for (size_t r = 0; r < house->plan.route_count; r++) {
        const PlanRoute *route = &house->plan.routes[r];
        double time = route_time(house, observation, route), mean = route->observed.mean;
        char simulated[32] = "-", error[32] = "-";
        if (time >= 0)
            snprintf(simulated, sizeof simulated, "%.2f", time);
        if (time >= 0 && mean > 0)
            snprintf(error, sizeof error, "%+.1f %%", 100 * (time - mean) / mean);
        if (mean > 0)
            printf("%-6s %12.2f %15.2f %16s %16s\n", route->id, mean, route->observed.deviation, simulated, error);
        else
            printf("%-6s %12s %15s %16s %16s\n", route->id, "not measured", "-", simulated, "-");
    }
}

void answer_print_text(const House *house, const Observation *observation) {
    char headline[256];
    answer_headline(house, observation, headline, sizeof headline);
    printf("%s\n%s%s%s\n\n", headline, house->plan.name, *house->plan.note ? ": " : "", house->plan.note);
    print_people(house, observation);
    print_routes(house, observation);
    if (observation->hazard_count)
        printf("\ndangerous points     clearance m  peak N  lost s\n");
    for (size_t h = 0; h < observation->hazard_count; h++) {
        const Hazard *hazard = &observation->hazards[h];
        printf("%2zu %-20s %8.3f %7.0f %7.1f   at (%.2f, %.2f)\n", h + 1, hazard->what, hazard->clearance,
               hazard->peak_force, hazard->lost_time, hazard->at.x, hazard->at.y);
    }
}
