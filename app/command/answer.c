#include "command/answer.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "visual/house/census.h"

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

/* The table of routes: (a) mean of the measured, (b) their deviation, (c) simulation, error ((c) - (a)) / (a). */
static json_t *answer_routes(const House *house, const Observation *observation) {
    json_t *routes = json_array();
    for (size_t r = 0; r < house->plan.route_count; r++) {
        const PlanRoute *route = &house->plan.routes[r];
        const Observed *observed = &route->observed;
        double time = census_route_time(house, observation, route);
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

static json_t *answer_crowds(const House *house, const Observation *observation) {
    json_t *crowds = json_array();
    Census census = census_make(house, observation);
    for (size_t p = 0; p < census.party_count; p++) {
        const Party *party = &census.parties[p];
        if (!party->crowd)
            continue;
        json_t *route = party->route ? json_string(party->route->id) : json_null();
        json_array_append_new(crowds, json_pack("{s:s, s:s, s:o, s:I, s:I, s:o, s:o, s:o, s:i, s:o}", "id",
                                                party->crowd->id, "profile", party->profile->name, "route", route,
                                                "people", (json_int_t)party->people, "out", (json_int_t)party->out,
                                                "mean_time", rounded(party->mean), "last_time", rounded(party->last),
                                                "mean_lost_time", rounded(party->lost), "contacts", party->contacts,
                                                "peak_force", rounded(party->peak_force)));
    }
    census_clear(&census);
    return crowds;
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
    return json_pack("{s:s, s:s, s:s, s:I, s:f, s:I, s:b, s:o, s:o, s:o, s:o, s:o, s:s}", "kind", "house", "house",
                     house->plan.name, "note", house->plan.note, "seed", (json_int_t)house->seed, "dt", observation->dt,
                     "steps", (json_int_t)observation->steps, "completed", observation->completed, "time",
                     rounded(observation->time), "people", people, "crowds", answer_crowds(house, observation),
                     "routes", answer_routes(house, observation), "hazards", answer_hazards(observation), "digest",
                     digest);
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

int answer_write(const json_t *answer, const char *path) {
    char *text = json_dumps(answer, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    int error = text_write_file(path, text, strlen(text));
    free(text);
    return error;
}
