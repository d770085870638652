#include "command/answer_text.h"

#include <stdio.h>

#include "result/house.h"
#include "result/text.h"
#include "result/headline.h"

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

void answer_text_add(Text *text, const House *house, const Observation *observation) {
    Arena arena = {0};
    Census census = census_make(house, observation);
    text_format(text, "%s\n", headline_sentence(house, observation, &arena));
    text_format(text, *house->plan.note ? "%s: %s\n" : "%s\n", house->plan.name, house->plan.note);
    if (census.people > CENSUS_ROWS) {
        result_text_take(text, "", result_house_parties(house, &census, false));
        add_stuck(text, house, observation, census.people - census.out);
    } else {
        result_text_take(text, "", result_house_people(house, observation));
    }
    result_text_take(text, "", result_house_routes(house, observation));
    result_text_take(text, "", result_house_hazards(observation));
    census_clear(&census);
    arena_clear(&arena);
}

void answer_text_print(const House *house, const Observation *observation) {
    Text text = {0};
    answer_text_add(&text, house, observation);
    fputs(text.text, stdout);
    memory_free(text.text);
}
