#include "command/answer.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file_write.h"
#include "command/output.h"
#include "result/house.h"
#include "result/headline.h"
#include "result/json.h"
#include "result/text.h"

json_t *answer_house(const House *house, const Observation *observation) {
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, observation->digest);
    Census census = census_make(house, observation);
    bool unknown = observation->interrupted && !observation->completed;
    json_t *answer = json_pack(
        "{s:s, s:s, s:s, s:I, s:f, s:I, s:o*, s:o, s:o, s:o, s:o, s:o, s:o, s:s}", "kind", "house", "house",
        house->plan.name, "note", house->plan.note, "seed", (json_int_t)house->seed, "dt", observation->dt, "steps",
        (json_int_t)observation->steps, "completed", unknown ? NULL : json_boolean(observation->completed), "time",
        isfinite(observation->time) ? json_real(round(observation->time * 1e6) / 1e6) : json_null(), "people",
        result_json_take_list(result_house_people(house, observation)), "crowds",
        result_json_take_list(result_house_parties(house, &census, true)), "routes",
        result_json_take_list(result_house_routes(house, observation)), "hazards",
        result_json_take_list(result_house_hazards(observation)), "hindrances",
        result_json_take_list(result_house_hindrances(house, observation)), "digest", digest);
    census_clear(&census);
    answer_mark_interrupted(answer, observation->interrupted);
    return answer;
}

void answer_mark_interrupted(json_t *answer, bool interrupted) {
    if (interrupted)
        json_object_set_new(answer, "interrupted", json_true());
}

void answer_print(json_t *answer) {
    char *text = json_dumps(answer, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    puts(text);
    free(text);
    json_decref(answer);
}

int answer_write(const json_t *answer, const char *path) {
    char *text = json_dumps(answer, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    int error = file_write_bytes(path, text, strlen(text));
    free(text);
    return error;
}

/* For people ------------------------------------------------------------------------------------------------------- */

enum { STUCK_ROWS = 10 /* of many people who are not out, listed one by one */ };

/* Adds the first people who are not out. */
static void add_stuck(Text *text, const House *house, const Observation *observation, size_t stuck) {
    ResultTable table = {0};
    for (size_t i = 0; i < house->person_count && table.record_count < STUCK_ROWS; i++)
        if (observation->people[i].took_part && !observation->people[i].completed)
            result_house_add_person(&table, house, observation, i);
    size_t listed = table.record_count;
    result_text_take(text, observation->interrupted ? "still inside\n" : "not out\n", table);
    if (listed < stuck)
        text_format(text, "and %zu more\n", stuck - listed);
}

void answer_text_add(Text *text, const House *house, const Observation *observation, const char *more) {
    Arena arena = {0};
    Census census = census_make(house, observation);
    text_format(text, "%s%s%s\n", headline_sentence(house, observation, &arena), *more ? "; " : "", more);
    text_format(text, *house->plan.note ? "%s: %s\n" : "%s\n", house->plan.name, house->plan.note);
    if (census.people > CENSUS_ROWS) {
        result_text_take(text, "", result_house_parties(house, &census, false));
        add_stuck(text, house, observation, census.people - census.out);
    } else {
        result_text_take(text, "", result_house_people(house, observation));
    }
    result_text_take(text, "", result_house_routes(house, observation));
    result_text_take(text, "", result_house_hindrances(house, observation));
    census_clear(&census);
    arena_clear(&arena);
}

void answer_text_print(const House *house, const Observation *observation, const char *more) {
    Text text = {0};
    answer_text_add(&text, house, observation, more);
    output_text(&text);
    memory_free(text.text);
}
