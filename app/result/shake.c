#include "result/shake.h"

#include <inttypes.h>
#include <stdio.h>

#include "base/text.h"
#include "house/house.h"

/* Returns "68 to 100 %"; NULL: the interval is unknown. */
static const char *confidence(const Share *share, Arena *arena) {
    return isfinite(share->low) ? text_in_arena(arena, "%.0f to %.0f %%", 100 * share->low, 100 * share->high) : NULL;
}

/* The keys of a share, in the order of JSON. Without a label only JSON has it. */
typedef struct ShareKeys {
    const char *shakes, *of, *share, *low, *high;
} ShareKeys;

#define SHARE_KEYS(name)                                                                                               \
    { name ".shakes", name ".of", name ".share", name ".q025", name ".q975" }

static void add_share(ResultTable *table, const Share *share, const ShareKeys *keys, const char *label,
                      const char *head) {
    result_add(table, (ResultRow){.key = keys->shakes, .kind = RESULT_COUNT, .number = (double)share->good});
    result_add(table, (ResultRow){.key = keys->of, .kind = RESULT_COUNT, .number = (double)share->all});
    result_add(table, (ResultRow){.key = keys->share,
                                  .label = label,
                                  .head = head,
                                  .kind = RESULT_NUMBER,
                                  .number = share->value,
                                  .unit = "%",
                                  .factor = 100,
                                  .decimals = 1});
    result_add(table, (ResultRow){.key = keys->low, .kind = RESULT_NUMBER, .number = share->low});
    result_add(table, (ResultRow){.key = keys->high, .kind = RESULT_NUMBER, .number = share->high});
    result_add(table, (ResultRow){.label = label ? "95 % confidence" : NULL, .text = confidence(share, &table->arena)});
}

static void add_time(ResultTable *table, const char *key, const char *label, const char *head, double time) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .head = head,
                                  .kind = RESULT_NUMBER,
                                  .number = time,
                                  .unit = label ? "s" : NULL,
                                  .decimals = 2});
}

static void add_times(ResultTable *table, const Distribution *time) {
    result_add(table, (ResultRow){.key = "time.count", .kind = RESULT_COUNT, .number = (double)time->count});
    add_time(table, "time.mean", NULL, NULL, time->mean);
    add_time(table, "time.q25", "out within, in 25 % of these shakes", "25 % within", time->quarters[0]);
    add_time(table, "time.q50", "out within, in half of these shakes", "median", time->median);
    add_time(table, "time.q75", "out within, in 75 % of these shakes", "75 % within", time->quarters[1]);
    add_time(table, "time.q95", "out within, in 95 % of these shakes", "95 % within", time->high);
    add_time(table, "time.least", NULL, NULL, time->least);
    add_time(table, "time.greatest", NULL, NULL, time->greatest);
}

/* The whole ------------------------------------------------------------------------------------------------------- */

ResultTable result_shake_answer(const ShakeFindings *findings) {
    static const ShareKeys keys = SHARE_KEYS("everybody_out");
    ResultTable table = {.numbers = RESULT_SHORTEST};
    bool out = findings->calm == SHAKE_CALM_OUT, known = out || findings->calm == SHAKE_CALM_NOT_OUT;
    bool interrupted = findings->calm == SHAKE_CALM_INTERRUPTED;
    add_share(&table, &findings->all_out, &keys, "shakes with all people out", "all out");
    add_times(&table, &findings->time);
    result_add(&table, (ResultRow){.key = "without_shake.completed",
                                   .label = "all people out without a shake",
                                   .kind = RESULT_FLAG,
                                   .number = out,
                                   .unknown = !known,
                                   .omitted = interrupted});
    result_add(&table, (ResultRow){.key = "without_shake.time",
                                   .label = "time without a shake",
                                   .kind = RESULT_NUMBER,
                                   .number = findings->calm_time,
                                   .unit = "s",
                                   .decimals = 2,
                                   .unknown = !out});
    result_end(&table);
    return table;
}

ResultTable result_shake_stops(const ShakeFindings *findings) {
    static const ShareKeys elsewhere = SHARE_KEYS("blocked_elsewhere"), caught = SHARE_KEYS("caught");
    ResultTable table = {.numbers = RESULT_SHORTEST};
    bool stops = findings->elsewhere.good > 0, falls = findings->caught.good > 0;
    add_share(&table, &findings->elsewhere, &elsewhere,
              stops ? "shakes in which a wall, a door or other people stop a person" : NULL, NULL);
    add_share(&table, &findings->caught, &caught, falls ? "shakes in which furniture falls on a person" : NULL, NULL);
    result_end(&table);
    return table;
}

const char *result_shake_simulated(const ShakeFindings *findings, Arena *arena) {
    if (findings->shakes < findings->study->runs)
        return text_in_arena(arena, "%zu of %zu shakes were simulated, with seeds from %" PRIu64 " on",
                             findings->shakes, findings->study->runs, findings->study->seed);
    return text_in_arena(arena,
                         findings->shakes == 1 ? "%zu shake was simulated, with seed %" PRIu64
                                               : "%zu shakes were simulated, with seeds from %" PRIu64 " on",
                         findings->shakes, findings->study->seed);
}

/* People ---------------------------------------------------------------------------------------------------------- */

ResultTable result_shake_people(const ShakeFindings *findings) {
    static const ShareKeys keys = SHARE_KEYS("out");
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t p = 0; p < findings->party_count; p++) {
        const ShakeParty *party = &findings->parties[p];
        bool single = party->people == 1;
        result_add(&table, (ResultRow){.key = "id", .label = "person", .text = party->id});
        result_add(&table, (ResultRow){.key = "profile", .label = "profile", .text = party->profile});
        result_add(&table, (ResultRow){.key = "people",
                                       .label = "people",
                                       .kind = RESULT_COUNT,
                                       .number = (double)party->people,
                                       .unknown = single});
        add_share(&table, &party->out, &keys, "shakes with all of them out", "out in");
        result_add(&table, (ResultRow){.key = "members_out",
                                       .label = "mean share of them out",
                                       .head = "mean share",
                                       .kind = RESULT_NUMBER,
                                       .number = party->members,
                                       .unit = "%",
                                       .factor = 100,
                                       .decimals = 1,
                                       .unknown = single});
        add_times(&table, &party->time);
        result_end(&table);
    }
    return table;
}

/* Furniture ------------------------------------------------------------------------------------------------------- */

static void add_piece(ResultTable *table, const ShakeFindings *findings, const ShakePiece *piece) {
    static const ShareKeys keys = SHARE_KEYS("blocks");
    const Furniture *furniture = &findings->house->plan.furniture[piece->index];
    char name[96];
    outline_name(&findings->house->plan, OWNER_FURNITURE, (int)piece->index, name, sizeof name);
    result_add(table, (ResultRow){.label = "furniture", .text = arena_text(&table->arena, name)});
    result_add(table, (ResultRow){.key = "id", .text = furniture->id});
    result_add(table, (ResultRow){.key = "name", .text = furniture->name});
    result_add(table, (ResultRow){.key = "probability",
                                  .label = "probability",
                                  .kind = RESULT_NUMBER,
                                  .number = furniture->probability,
                                  .decimals = 2});
    result_add(table, (ResultRow){.key = "toppled", .kind = RESULT_COUNT, .number = (double)piece->toppled});
    result_add(table, (ResultRow){.key = "toppled_share",
                                  .label = "falls in",
                                  .kind = RESULT_NUMBER,
                                  .number = (double)piece->toppled / (double)findings->shakes,
                                  .unit = "%",
                                  .factor = 100,
                                  .decimals = 1});
    result_add(table, (ResultRow){.key = "toppled_and_not_all_out",
                                  .label = "shakes in which it falls and not all people are out",
                                  .head = "falls, not all out",
                                  .kind = RESULT_COUNT,
                                  .number = (double)piece->with_loss});
    add_share(table, &piece->stops, &keys, "stops people in", NULL);
    result_end(table);
}

ResultTable result_shake_furniture(const ShakeFindings *findings) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t p = 0; p < findings->piece_count; p++)
        add_piece(&table, findings, &findings->pieces[p]);
    return table;
}
