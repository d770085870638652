#include "command/cases_words.h"

#include <stdio.h>
#include <string.h>

#include "inquiry/case_run.h"

const char *cases_words_verdict(Verdict verdict) {
    static const char *const words[] = {[VERDICT_NOT_RUN] = "not run",
                                        [VERDICT_PASSED] = "yes",
                                        [VERDICT_FAILED] = "no",
                                        [VERDICT_DOES_NOT_APPLY] = "does not apply"};
    return words[verdict];
}

/* " s", " persons/(m s)", or "" for a pure number. */
static const char *unit_words(const VerificationCheck *check) {
    static const char *const units[][2] = {
        {"s", " s"}, {"m/s", " m/s"}, {"1/(m s)", " persons/(m s)"}, {"1/m2", " persons/m\u00b2"}};
    for (size_t u = 0; u < sizeof units / sizeof *units; u++)
        if (strcmp(check->unit, units[u][0]) == 0)
            return units[u][1];
    return "";
}

static void add_ids(char *text, size_t size, const char *before, const Ids *ids) {
    for (size_t i = 0; i < ids->count; i++) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s", i ? ", " : before, ids->at[i]);
    }
}

void cases_words_question(const VerificationCheck *check, char text[CASES_WORDS_SIZE]) {
    if (*check->title) {
        snprintf(text, CASES_WORDS_SIZE, "%s", check->title);
        return;
    }
    snprintf(text, CASES_WORDS_SIZE, "%s%s", check->is_ratio ? "ratio: " : "", check->measure->meaning);
    add_ids(text, CASES_WORDS_SIZE, ": ", &check->question.of);
    const char *const parts[][2] = {
        {", exit ", check->question.exit}, {", variant ", check->variant}, {", against ", check->than}};
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
        size_t used = strlen(text);
        if (*parts[p][1])
            snprintf(text + used, CASES_WORDS_SIZE - used, "%s%s", parts[p][0], parts[p][1]);
    }
    add_ids(text, CASES_WORDS_SIZE, ", against ", &check->than_of);
}

void cases_words_limits(const VerificationCheck *check, char text[CASES_WORDS_SIZE]) {
    const char *unit = unit_words(check);
    if (check->low == check->high)
        snprintf(text, CASES_WORDS_SIZE, "exactly %g%s", check->low, unit);
    else if (check->low == -HUGE_VAL)
        snprintf(text, CASES_WORDS_SIZE, "at most %g%s", check->high, unit);
    else if (check->high == HUGE_VAL)
        snprintf(text, CASES_WORDS_SIZE, "at least %g%s", check->low, unit);
    else
        snprintf(text, CASES_WORDS_SIZE, "%g to %g%s", check->low, check->high, unit);
}

void cases_words_value(const VerificationCheck *check, char text[CASES_WORDS_SIZE]) {
    if (!isfinite(check->value))
        snprintf(text, CASES_WORDS_SIZE, "-");
    else
        snprintf(text, CASES_WORDS_SIZE, "%.4g%s", check->value, unit_words(check));
}

void cases_words_why(const VerificationCheck *check, char text[3 * CASES_WORDS_SIZE]) {
    char value[CASES_WORDS_SIZE], limits[CASES_WORDS_SIZE];
    cases_words_value(check, value);
    cases_words_limits(check, limits);
    size_t size = 3 * CASES_WORDS_SIZE;
    snprintf(text, size, "%s, must be %s%s%s%s%s", isfinite(check->value) ? value : "no value", limits,
             *check->note ? "; " : "", check->note, *check->why ? "; " : "", check->why);
}

void cases_words_summary(const Verification *cases, size_t count, char text[CASES_WORDS_SIZE]) {
    size_t counts[VERDICT_DOES_NOT_APPLY + 1] = {0};
    for (size_t i = 0; i < count; i++)
        counts[case_run_verdict(&cases[i])]++;
    size_t apply = count - counts[VERDICT_DOES_NOT_APPLY];
    snprintf(text, CASES_WORDS_SIZE, "%zu of %zu tests passed", counts[VERDICT_PASSED], apply);
    const struct {
        size_t count;
        const char *words;
    } rest[] = {{counts[VERDICT_FAILED], ", %zu did not"},
                {counts[VERDICT_NOT_RUN], ", %zu were not run"},
                {counts[VERDICT_DOES_NOT_APPLY],
                 counts[VERDICT_DOES_NOT_APPLY] == 1 ? "; %zu does not apply" : "; %zu do not apply"}};
    for (size_t r = 0; r < sizeof rest / sizeof *rest; r++) {
        size_t used = strlen(text);
        if (rest[r].count)
            snprintf(text + used, CASES_WORDS_SIZE - used, rest[r].words, rest[r].count);
    }
}
