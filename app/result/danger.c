#include "result/danger.h"

#include "base/text.h"
#include "house/touch.h"
#include "result/shares.h"

const char *result_danger_words(double speed, Arena *arena) {
    return text_in_arena(arena, "a %s at %.2f m/s", danger_word(speed), speed);
}

static void add_place(ResultTable *table, const House *house, size_t person, const DangerPlace *place, bool many) {
    const Share *share = &place->share;
    bool hand = place->part == PART_HAND;
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = house->people[person].id});
    result_add(table, (ResultRow){.key = "x", .kind = RESULT_NUMBER, .number = place->at.x});
    result_add(table, (ResultRow){.key = "y", .kind = RESULT_NUMBER, .number = place->at.y});
    result_add(table,
               (ResultRow){.key = "what", .label = "touched", .text = text_in_arena(&table->arena, "%s", place->what)});
    result_add(table, (ResultRow){.key = "part", .label = "with the", .text = touch_part(place->part)});
    result_add(table, (ResultRow){.key = "share",
                                  .label = many ? "by" : NULL,
                                  .kind = RESULT_NUMBER,
                                  .number = share->value,
                                  .text = result_shares_text(&table->arena, share)});
    result_add(table, (ResultRow){.key = "share_low", .kind = RESULT_NUMBER, .number = share->low});
    result_add(table, (ResultRow){.key = "share_high", .kind = RESULT_NUMBER, .number = share->high});
    result_add(table, (ResultRow){
                          .key = "word", .label = "as a", .text = hand ? "clamped hand" : danger_word(place->speed95)});
    result_add_number(table, "speed95", many ? "speed 95 %" : "speed", place->speed95, "m/s", 2);
    result_add_number(table, "mass", "effective mass", place->mass, "kg", 0);
    result_add_number(table, "energy", many ? "energy in a run" : "energy", place->energy, "J", 3);
    result_add_number(table, "impulse", hand ? NULL : "impulse", hand ? (double)NAN : place->impulse, "N s", 1);
    result_add_number(table, "squeeze", hand ? NULL : "squeeze", hand ? (double)NAN : place->squeeze, "N", 0);
    result_end(table);
}

void result_danger_add(ResultTable *table, const House *house, size_t person, const Danger *danger) {
    for (size_t p = 0; p < danger->count && p < RESULT_DANGER_MOST; p++)
        add_place(table, house, person, &danger->places[p], danger->drivers > 1);
}

ResultTable result_danger_places(const House *house, const Observation *observation, const Drivers *drivers) {
    ResultTable table = {0};
    for (size_t i = 0; i < house->person_count; i++) {
        if (house->people[i].profile->driving == DRIVING_WALKER || !observation->people[i].took_part)
            continue;
        Danger danger =
            drivers && drivers->count ? danger_of_drivers(house, drivers, i) : danger_of_run(house, observation, i);
        result_danger_add(&table, house, i, &danger);
        danger_free(&danger);
    }
    return table;
}

ResultTable result_danger_limits(double mass) {
    ResultTable table = {0};
    for (size_t l = 0; l < DANGER_LIMITS; l++) {
        const DangerLimit *limit = &danger_limits[l];
        result_add(&table, (ResultRow){.key = "part", .label = "clamped", .text = limit->part});
        result_add_number(&table, "still", "limit at rest", limit->still, "N", 0);
        result_add_number(&table, "impact", "limit in an impact", limit->impact, "N", 0);
        result_add_number(&table, "stiffness", "stiffness", limit->stiffness / 1e3, "N/mm", 0);
        result_add_number(&table, "speed_still", "reached at", danger_clamp_speed(limit->still, mass, limit->stiffness),
                          "m/s", 2);
        result_add_number(&table, "speed_impact", "and at", danger_clamp_speed(limit->impact, mass, limit->stiffness),
                          "m/s", 2);
        result_add(&table, (ResultRow){.key = "status", .label = "status", .text = limit->status});
        result_add(&table, (ResultRow){.key = "source", .label = "source", .text = limit->source});
        result_end(&table);
    }
    return table;
}
