#include "command/report.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "command/answer.h"
#include "laboratory/census.h"

enum {
    NAME_LEAST = 12, /* characters for a name's column */
    STUCK_ROWS = 10, /* of many people who are not out, listed one by one */
};

/* "p1 is blocked at door d2 after 18.4 s" */
static void say_stuck(const House *house, const Observation *observation, size_t i, char *text, size_t size) {
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

void report_headline(const House *house, const Observation *observation, char *text, size_t size) {
    Census census = census_take(house, observation);
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
        char why[REPORT_HEADLINE / 2], others[64] = "";
        if (census.out)
            snprintf(others, sizeof others, "; the other%s out in %.1f s", census.out > 1 ? "s" : "", census.last);
        if (stuck == 1) {
            say_stuck(house, observation, census.stuck, why, sizeof why);
            snprintf(text, size, "%s%s", why, others);
        } else {
            census_reasons(house, &census, true, why, sizeof why);
            snprintf(text, size, "%zu of %zu are not out: %s%s", stuck, census.people, why, others);
        }
    }
    census_clear(&census);
}

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
        double time = answer_route_time(house, observation, route), mean = route->observed.mean;
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

void report_print(const House *house, const Observation *observation) {
    char headline[REPORT_HEADLINE];
    report_headline(house, observation, headline, sizeof headline);
    printf("%s\n%s%s%s\n\n", headline, house->plan.name, *house->plan.note ? ": " : "", house->plan.note);
    Census census = census_take(house, observation);
    if (census.people > CENSUS_ROWS)
        print_many(house, observation, &census);
    else
        print_people(house, observation, true, SIZE_MAX);
    census_clear(&census);
    print_routes(house, observation);
    print_hazards(observation);
}
