#include "result/shares.h"

#include <stdint.h>

#include "base/text.h"

const char *result_shares_text(Arena *arena, const Share *share) {
    return text_in_arena(arena, "%.0f %% (%.0f to %.0f)", 100 * share->value, 100 * share->low, 100 * share->high);
}

static void add_share(ResultTable *table, const char *const *keys, const char *label, size_t good, size_t all) {
    Share share = montecarlo_share(good, all);
    result_add(table, (ResultRow){.key = keys[0], .kind = RESULT_COUNT, .number = (double)good});
    result_add(table, (ResultRow){.key = keys[1],
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = share.value,
                                  .text = result_shares_text(&table->arena, &share)});
    result_add(table, (ResultRow){.key = keys[2], .kind = RESULT_NUMBER, .number = share.low});
    result_add(table, (ResultRow){.key = keys[3], .kind = RESULT_NUMBER, .number = share.high});
}

static void add_person(ResultTable *table, const Inhabitant *person, const Shares *shares) {
    static const char *const keys[][4] = {{"fit.count", "fit.share", "fit.low", "fit.high"},
                                          {"drive.count", "drive.share", "drive.low", "drive.high"},
                                          {"skid.count", "skid.share", "skid.low", "skid.high"},
                                          {"carried.count", "carried.share", "carried.low", "carried.high"},
                                          {"none.count", "none.share", "none.low", "none.high"}};
    const size_t *count = shares->count;
    size_t all = shares->drivers;
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = person->id});
    result_add(table, (ResultRow){.key = "route", .label = "route", .text = person->route ? person->route->id : NULL});
    result_add(table, (ResultRow){.key = "drivers", .label = "drivers", .kind = RESULT_COUNT, .number = (double)all});
    add_share(table, keys[0], "fit", all - count[PASSAGE_NONE], all);
    add_share(table, keys[1], "drive", count[PASSAGE_DRIVES], all);
    add_share(table, keys[2], "only with a skid", count[PASSAGE_SKIDS], all);
    add_share(table, keys[3], "only carried", count[PASSAGE_CARRIED], all);
    add_share(table, keys[4], "not at all", count[PASSAGE_NONE], all);
    bool refuses = shares->refused > 0;
    Arena *arena = &table->arena;
    result_add(table, (ResultRow){.key = "refused.what",
                                  .text = refuses ? text_in_arena(arena, "%s", shares->what) : NULL,
                                  .omitted = !refuses});
    result_add(table,
               (ResultRow){.label = "refused most at",
                           .text = refuses ? text_in_arena(arena, "%s (%zu)", shares->what, shares->refused) : NULL,
                           .omitted = !refuses});
    result_add(table, (ResultRow){.key = "refused.count", .kind = RESULT_COUNT, .number = (double)shares->refused});
    result_add(table,
               (ResultRow){.key = "refused.x", .kind = RESULT_NUMBER, .number = shares->at.x, .omitted = !refuses});
    result_add(table,
               (ResultRow){.key = "refused.y", .kind = RESULT_NUMBER, .number = shares->at.y, .omitted = !refuses});
    result_add(
        table,
        (ResultRow){.key = "tried", .label = "bodies tried", .kind = RESULT_COUNT, .number = (double)shares->tried});
    result_end(table);
}

ResultTable result_shares_table(const House *house, const Shares *shares) {
    ResultTable table = {.numbers = RESULT_REAL};
    for (size_t i = 0; i < house->person_count; i++)
        if (shares[i].drivers && !shares[i].interrupted)
            add_person(&table, &house->people[i], &shares[i]);
    return table;
}
