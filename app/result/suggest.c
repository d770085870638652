#include "result/suggest.h"

#include "base/text.h"

/* Returns "--set door.d3.width=0.83", for a command line. */
static const char *command_of(const Suggestion *suggestion, Arena *arena) {
    const char *words = "";
    for (size_t s = 0; s < suggestion->setting_count; s++)
        words = text_in_arena(arena, *words ? "%s --set %s" : "%s--set %s", words, suggestion->settings[s]);
    return words;
}

/* Returns "payable, if a sliding door replaces it (read second-hand)" of each kind of work; `named` says which. */
static const char *pay_words(const RuleSet *set, int work, bool named, Arena *arena) {
    static const char *const works[PLAN_WORKS] = {"hinged door: ", "sliding door: ", "opening: ", "furniture: "};
    const RulePay *pay = rule_set_pay(set, work);
    const char *name = named ? works[work] : "";
    if (!pay)
        return text_in_arena(arena, "%scannot be told", name);
    return text_in_arena(arena, *pay->condition ? "%s%s, %s (%s)" : "%s%s%s (%s)", name, rule_set_pays_name(pay->pays),
                         pay->condition, rule_set_status_name(pay->status));
}

/* Adds what a set says about paying for the works of a change; in the quiet role where that was not read. */
static void add_payer(ResultTable *table, const Suggestion *suggestion, const RuleSet *set) {
    const char *words = NULL;
    size_t count = 0;
    bool read = true;
    for (int w = 0; w < PLAN_WORKS; w++)
        count += suggestion->works[w];
    for (int w = 0; w < PLAN_WORKS; w++) {
        if (!suggestion->works[w])
            continue;
        const RulePay *pay = rule_set_pay(set, w);
        const char *one = pay_words(set, w, count > 1, &table->arena);
        words = words ? text_in_arena(&table->arena, "%s; %s", words, one) : one;
        read &= pay && pay->status == STATUS_READ;
    }
    result_add(table, (ResultRow){.key = text_in_arena(&table->arena, "paid.%s", set->id),
                                  .label = set->id,
                                  .text = words,
                                  .role = read ? ROLE_TEXT : ROLE_DIM_TEXT});
}

static void add_change(ResultTable *table, const Suggestion *suggestion, size_t rank, const RuleSets *payers) {
    result_add(table, (ResultRow){.label = "rank", .text = text_in_arena(&table->arena, "%zu", rank)});
    result_add(table, (ResultRow){.key = "words", .label = "change", .text = suggestion->text});
    result_add(table, (ResultRow){.key = "settings",
                                  .kind = RESULT_TEXTS,
                                  .texts = suggestion->settings,
                                  .count = suggestion->setting_count});
    result_add(table, (ResultRow){.key = "size",
                                  .label = "size of the change",
                                  .head = "size",
                                  .kind = RESULT_NUMBER,
                                  .number = suggestion->size,
                                  .unit = "m",
                                  .decimals = 2});
    result_add(table, (ResultRow){.key = "time",
                                  .label = "all out in",
                                  .head = "all out",
                                  .kind = RESULT_NUMBER,
                                  .number = suggestion->time,
                                  .unit = "s",
                                  .decimals = 1});
    for (size_t s = 0; payers && s < payers->count; s++)
        add_payer(table, suggestion, &payers->sets[s]);
    result_add(table, (ResultRow){.label = "settings", .text = command_of(suggestion, &table->arena)});
    result_end(table);
}

ResultTable result_suggest_changes(const SuggestList *list, const RuleSets *payers) {
    ResultTable table = {.numbers = RESULT_REAL};
    for (size_t i = 0; i < list->count; i++)
        add_change(&table, &list->list[i], i + 1, payers);
    return table;
}

const char *result_suggest_sentence(const SuggestList *list, Arena *arena) {
    if (list->out_already)
        return text_in_arena(arena, "All people are out in %.1f s without a change: nothing needs to be changed",
                             list->time);
    return list->count     ? "Smallest changes that let all people out"
           : list->stopped ? "The search was interrupted before it found a change that lets all people out"
                           : "No change was found that lets all people out";
}

const char *result_suggest_tried(const SuggestList *list, Arena *arena) {
    const char *format = list->stopped
                             ? "Houses tried before the search was interrupted: %zu; there may be other changes"
                         : list->exhausted ? "Houses tried: %zu, as many as are allowed; there may be other changes"
                                           : "Houses tried: %zu";
    return text_in_arena(arena, format, list->tries);
}

const char *result_suggest_outcome(const Suggestion *suggestion, Arena *arena) {
    return text_in_arena(arena, "all people are out in %.1f s", suggestion->time);
}
