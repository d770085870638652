#include "command/answer_text.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "visual/house/census.h"
#include "visual/house/headline.h"

enum {
    NAME_LEAST = 12, /* characters for a name's column */
    STUCK_ROWS = 10, /* of many people who are not out, listed one by one */
};

static int wider(int width, const char *name) {
    int length = (int)strlen(name);
    return length > width ? length : width;
}

/* Without the sign of a nought that rounding leaves. */
static double tenths(double value) {
    return fabs(value) < 0.05 ? 0 : value;
}

static void print_people_head(int width) {
    printf("%-*s %-16s %-6s %-8s %9s %9s %11s %9s %8s %8s %8s  %s\n", width, "person", "profile", "route", "exit",
           "time s", "reversals", "narrowest m", "contacts", "peak N", "ring s", "lost s", "answer");
}

static void print_person(const House *house, size_t i, const PersonObservation *person, int width) {
    const Inhabitant *inhabitant = &house->people[i];
    char reversals[16] = "-"; /* nobody on foot has any */
    if (!census_walks(inhabitant->profile))
        snprintf(reversals, sizeof reversals, "%d", person->reversals);
    printf("%-*s %-16s %-6s %-8s %9.2f %9s %11.3f %9d %8.0f %8.1f %8.1f  %s\n", width, inhabitant->id,
           inhabitant->profile->name, inhabitant->route ? inhabitant->route->id : "-",
           person->exit < house->plan.exit_count ? house->plan.exits[person->exit].id : "-", person->time, reversals,
           person->narrowest, person->contacts, person->peak_force, person->ring_time, tenths(person->lost_time),
           person->completed ? "out" : observation_reason(person->reason));
}

/* Everybody, or only those who are not out; at most `most`. Returns how many. */
static size_t print_people(const House *house, const Observation *observation, bool all, size_t most) {
    int width = NAME_LEAST;
    size_t listed = 0;
    for (int turn = 0; turn <= 1; turn++) {
        listed = 0;
        for (size_t i = 0; i < house->person_count && listed < most; i++) {
            const PersonObservation *person = &observation->people[i];
            if (!person->took_part || (!all && person->completed))
                continue;
            listed++;
            if (turn == 0)
                width = wider(width, house->people[i].id);
            else
                print_person(house, i, person, width);
        }
        if (turn == 0)
            print_people_head(width);
    }
    return listed;
}

static void print_parties(const House *house, const Census *census) {
    int width = NAME_LEAST;
    for (size_t p = 0; p < census->party_count; p++)
        width = wider(width, census_party_name(house, &census->parties[p]));
    printf("%-*s %-16s %-6s %7s %7s %9s %9s %8s %9s %8s\n", width, "people", "profile", "route", "number", "out",
           "mean s", "last s", "lost s", "contacts", "peak N");
    for (size_t p = 0; p < census->party_count; p++) {
        const Party *party = &census->parties[p];
        char mean[16] = "-", last[16] = "-";
        if (party->out) {
            snprintf(mean, sizeof mean, "%.2f", party->mean);
            snprintf(last, sizeof last, "%.2f", party->last);
        }
        printf("%-*s %-16s %-6s %7zu %7zu %9s %9s %8.1f %9d %8.0f\n", width, census_party_name(house, party),
               party->profile->name, party->route ? party->route->id : "-", party->people, party->out, mean, last,
               tenths(party->lost), party->contacts, party->peak_force);
    }
}

static void print_many(const House *house, const Observation *observation, const Census *census) {
    size_t stuck = census->people - census->out;
    print_parties(house, census);
    if (!stuck)
        return;
    printf("\nnot out\n");
    size_t listed = print_people(house, observation, false, STUCK_ROWS);
    if (listed < stuck)
        printf("and %zu more\n", stuck - listed);
}

static void print_routes(const House *house, const Observation *observation) {
    if (!house->plan.route_count)
        return;
    printf("\n%-6s %12s %14s %15s %16s\n", "route", "mean (a) s", "deviation (b) s", "simulation (c) s",
           "((c)-(a))/(a)");
    for (size_t r = 0; r < house->plan.route_count; r++) {
        const PlanRoute *route = &house->plan.routes[r];
        double time = census_route_time(house, observation, route), mean = route->observed.mean;
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

static void print_hazards(const Observation *observation) {
    int width = 20;
    for (size_t h = 0; h < observation->hazard_count; h++)
        width = wider(width, observation->hazards[h].what);
    if (observation->hazard_count)
        printf("\n%-*s clearance m  peak N  lost s\n", width, "dangerous points");
    for (size_t h = 0; h < observation->hazard_count; h++) {
        const Hazard *hazard = &observation->hazards[h];
        char clearance[16] = "-";
        if (isfinite(hazard->clearance))
            snprintf(clearance, sizeof clearance, "%.3f", hazard->clearance);
        printf("%2zu %-*s %8s %7.0f %7.1f   at (%.2f, %.2f)\n", h + 1, width, hazard->what, clearance,
               hazard->peak_force, hazard->lost_time, hazard->at.x, hazard->at.y);
    }
}

void answer_text_print(const House *house, const Observation *observation) {
    char headline[HEADLINE_TEXT];
    headline_text(house, observation, headline, sizeof headline);
    printf("%s\n%s%s%s\n\n", headline, house->plan.name, *house->plan.note ? ": " : "", house->plan.note);
    Census census = census_make(house, observation);
    if (census.people > CENSUS_ROWS)
        print_many(house, observation, &census);
    else
        print_people(house, observation, true, SIZE_MAX);
    census_clear(&census);
    print_routes(house, observation);
    print_hazards(observation);
}
