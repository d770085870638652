#include "result/cases.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "inquiry/case_run.h"

static const char *verdict_name(Verdict verdict) {
    static const char *const names[] = {[VERDICT_NOT_RUN] = "not run",
                                        [VERDICT_PASSED] = "yes",
                                        [VERDICT_FAILED] = "no",
                                        [VERDICT_DOES_NOT_APPLY] = "does not apply"};
    return names[verdict];
}

static void add_text(ResultTable *table, const char *key, const char *label, const char *text) {
    result_add(table, (ResultRow){.key = key, .label = label, .text = text});
}

static void add_verdict(ResultTable *table, Verdict verdict) {
    result_add(table, (ResultRow){.key = "passed",
                                  .label = "passed",
                                  .text = verdict_name(verdict),
                                  .role = verdict == VERDICT_FAILED ? ROLE_ERROR : ROLE_TEXT});
}

/* Returns "a, b", or whichever of both is not empty. */
static const char *joined(Arena *arena, const char *a, const char *between, const char *b) {
    return *a && *b ? text_in_arena(arena, "%s%s%s", a, between, b) : *a ? a : b;
}

/* Cases ----------------------------------------------------------------------------------------------------------- */

ResultTable result_cases_list(const Verification *cases, size_t count) {
    ResultTable table = {0};
    for (size_t i = 0; i < count; i++) {
        add_text(&table, "id", NULL, cases[i].id);
        add_text(&table, "suite", "suite", cases[i].suite);
        add_text(&table, "title", "test", cases[i].title);
        add_text(&table, "note", "source and assumptions", cases[i].note);
        add_verdict(&table, case_run_verdict(&cases[i]));
        result_end(&table);
    }
    return table;
}

ResultTable result_cases_excluded(const Verification *cases, size_t count) {
    ResultTable table = {0};
    for (size_t i = 0; i < count; i++) {
        if (cases[i].applies)
            continue;
        add_text(&table, NULL, "suite", cases[i].suite);
        add_text(&table, NULL, "test", cases[i].title);
        add_text(&table, "reason", "why not", cases[i].reason);
        result_end(&table);
    }
    return table;
}

/* Checks ---------------------------------------------------------------------------------------------------------- */

/* The unit as people read it; NULL for a pure number. */
static const char *read_unit(const VerificationCheck *check) {
    static const char *const units[][2] = {
        {"s", "s"}, {"m/s", "m/s"}, {"1/(m s)", "persons/(m s)"}, {"1/m2", "persons/m\u00b2"}};
    for (size_t u = 0; u < sizeof units / sizeof *units; u++)
        if (strcmp(check->condition.unit, units[u][0]) == 0)
            return units[u][1];
    return NULL;
}

static const char *ids_of(Arena *arena, const Ids *ids) {
    const char *list = "";
    for (size_t i = 0; i < ids->count; i++)
        list = joined(arena, list, ", ", ids->at[i]);
    return list;
}

/* Returns the meaning of the measure, of whom it is, and with what it is compared. */
static const char *question_of(Arena *arena, const VerificationCheck *check) {
    if (*check->condition.title)
        return check->condition.title;
    const char *people = ids_of(arena, &check->condition.question.of), *others = ids_of(arena, &check->than_of);
    const char *meaning = check->condition.measure->meaning;
    const char *question = check->is_ratio ? text_in_arena(arena, "ratio: %s", meaning) : meaning;
    const struct {
        const char *format, *name;
    } parts[] = {{"exit %s", check->condition.question.exit},
                 {"variant %s", check->variant},
                 {"against %s", check->than},
                 {"against %s", others}};
    question = joined(arena, question, ": ", people);
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        if (*parts[p].name)
            question = joined(arena, question, ", ", text_in_arena(arena, parts[p].format, parts[p].name));
    return question;
}

static const char *quantity(Arena *arena, const char *format, double value, const char *unit) {
    const char *number = text_in_arena(arena, format, value);
    return unit ? text_in_arena(arena, "%s %s", number, unit) : number;
}

static const char *criterion_of(Arena *arena, const VerificationCheck *check) {
    const char *unit = read_unit(check);
    const char *low = quantity(arena, "%g", check->condition.low, unit),
               *high = quantity(arena, "%g", check->condition.high, unit);
    if (check->condition.low == check->condition.high)
        return text_in_arena(arena, "exactly %s", low);
    if (check->condition.low == -HUGE_VAL)
        return text_in_arena(arena, "at most %s", high);
    if (check->condition.high == HUGE_VAL)
        return text_in_arena(arena, "at least %s", low);
    return text_in_arena(arena, "%g to %s", check->condition.low, high);
}

static void add_check(ResultTable *table, const VerificationCheck *check) {
    Arena *arena = &table->arena;
    bool known = isfinite(check->condition.value), failed = check->condition.verdict == VERDICT_FAILED;
    const char *value = known ? quantity(arena, "%.4g", check->condition.value, read_unit(check)) : NULL;
    const char *criterion = criterion_of(arena, check);
    const char *reason = joined(arena, check->condition.note, "; ", check->condition.why);
    const char *must = known ? text_in_arena(arena, "%s, must be %s", value, criterion)
                             : text_in_arena(arena, "no value, must be %s", criterion);
    add_text(table, "measure", NULL, check->condition.measure->name);
    add_text(table, "question", "what is measured", question_of(arena, check));
    result_add(table, (ResultRow){.key = "low", .kind = RESULT_NUMBER, .number = check->condition.low});
    result_add(table, (ResultRow){.key = "high", .kind = RESULT_NUMBER, .number = check->condition.high});
    add_text(table, "unit", NULL, check->condition.unit);
    add_text(table, NULL, "criterion", criterion);
    result_add(table, (ResultRow){.key = "seeds", .kind = RESULT_COUNT, .number = check->seeds});
    result_add(
        table,
        (ResultRow){
            .key = "value", .label = "ours", .kind = RESULT_NUMBER, .number = check->condition.value, .text = value});
    add_verdict(table, check->condition.verdict);
    result_add(table, (ResultRow){.label = "reason", .text = reason, .omitted = !failed});
    result_add(table, (ResultRow){.key = "why", .text = joined(arena, must, "; ", reason), .omitted = !failed});
    result_end(table);
}

ResultTable result_cases_checks(const Verification *verification) {
    ResultTable table = {0};
    for (size_t c = 0; c < verification->check_count; c++)
        add_check(&table, &verification->checks[c]);
    return table;
}

/* Summary --------------------------------------------------------------------------------------------------------- */

const char *result_cases_summary(const Verification *cases, size_t count, Arena *arena) {
    size_t counts[VERDICT_DOES_NOT_APPLY + 1] = {0};
    for (size_t i = 0; i < count; i++)
        counts[case_run_verdict(&cases[i])]++;
    size_t others = counts[VERDICT_DOES_NOT_APPLY];
    const char *summary = text_in_arena(arena, "%zu of %zu tests passed", counts[VERDICT_PASSED], count - others);
    if (counts[VERDICT_FAILED])
        summary = joined(arena, summary, ", ", text_in_arena(arena, "%zu did not", counts[VERDICT_FAILED]));
    if (counts[VERDICT_NOT_RUN])
        summary = joined(arena, summary, ", ", text_in_arena(arena, "%zu were not run", counts[VERDICT_NOT_RUN]));
    if (others == 1)
        return joined(arena, summary, "; ", "1 does not apply");
    return others ? joined(arena, summary, "; ", text_in_arena(arena, "%zu do not apply", others)) : summary;
}
