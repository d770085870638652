#include "command/cases_text.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "inquiry/case_run.h"

/* Sentences ---------------------------------------------------------------------------------------------------------*/

const char *cases_text_verdict(Verdict verdict) {
    static const char *const words[] = {[VERDICT_NOT_RUN] = "not run",
                                        [VERDICT_PASSED] = "yes",
                                        [VERDICT_FAILED] = "no",
                                        [VERDICT_DOES_NOT_APPLY] = "does not apply"};
    return words[verdict];
}

/* Returns " s", " persons/(m s)", or "" for a pure number. */
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

void cases_text_question(const VerificationCheck *check, char text[CASES_TEXT_SIZE]) {
    if (*check->title) {
        snprintf(text, CASES_TEXT_SIZE, "%s", check->title);
        return;
    }
    snprintf(text, CASES_TEXT_SIZE, "%s%s", check->is_ratio ? "ratio: " : "", check->measure->meaning);
    add_ids(text, CASES_TEXT_SIZE, ": ", &check->question.of);
    const char *const parts[][2] = {
        {", exit ", check->question.exit}, {", variant ", check->variant}, {", against ", check->than}};
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
        size_t used = strlen(text);
        if (*parts[p][1])
            snprintf(text + used, CASES_TEXT_SIZE - used, "%s%s", parts[p][0], parts[p][1]);
    }
    add_ids(text, CASES_TEXT_SIZE, ", against ", &check->than_of);
}

void cases_text_limits(const VerificationCheck *check, char text[CASES_TEXT_SIZE]) {
    const char *unit = unit_words(check);
    if (check->low == check->high)
        snprintf(text, CASES_TEXT_SIZE, "exactly %g%s", check->low, unit);
    else if (check->low == -HUGE_VAL)
        snprintf(text, CASES_TEXT_SIZE, "at most %g%s", check->high, unit);
    else if (check->high == HUGE_VAL)
        snprintf(text, CASES_TEXT_SIZE, "at least %g%s", check->low, unit);
    else
        snprintf(text, CASES_TEXT_SIZE, "%g to %g%s", check->low, check->high, unit);
}

void cases_text_value(const VerificationCheck *check, char text[CASES_TEXT_SIZE]) {
    if (!isfinite(check->value))
        snprintf(text, CASES_TEXT_SIZE, "-");
    else
        snprintf(text, CASES_TEXT_SIZE, "%.4g%s", check->value, unit_words(check));
}

void cases_text_why(const VerificationCheck *check, char text[3 * CASES_TEXT_SIZE]) {
    char value[CASES_TEXT_SIZE], limits[CASES_TEXT_SIZE];
    cases_text_value(check, value);
    cases_text_limits(check, limits);
    size_t size = 3 * CASES_TEXT_SIZE;
    snprintf(text, size, "%s, must be %s%s%s%s%s", isfinite(check->value) ? value : "no value", limits,
             *check->note ? "; " : "", check->note, *check->why ? "; " : "", check->why);
}

void cases_text_summary(const Verification *cases, size_t count, char text[CASES_TEXT_SIZE]) {
    size_t counts[VERDICT_DOES_NOT_APPLY + 1] = {0};
    for (size_t i = 0; i < count; i++)
        counts[case_run_verdict(&cases[i])]++;
    size_t apply = count - counts[VERDICT_DOES_NOT_APPLY];
    snprintf(text, CASES_TEXT_SIZE, "%zu of %zu tests passed", counts[VERDICT_PASSED], apply);
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
            snprintf(text + used, CASES_TEXT_SIZE - used, rest[r].words, rest[r].count);
    }
}

/* Terminal ----------------------------------------------------------------------------------------------------------*/

/* Prints a column of `width` characters, each of which may be several bytes of UTF-8. */
static void print_column(const char *words, int width) {
    for (const char *at = words; *at; at++)
        width -= ((unsigned char)*at & 0xc0) != 0x80;
    printf("%s%*s  ", words, width > 0 ? width : 0, "");
}

static void print_case(const Verification *verification) {
    printf("%s: %s\n", verification->suite, verification->title);
    if (!verification->applies)
        printf("  does not apply: %s\n", verification->reason);
    for (size_t c = 0; c < verification->check_count; c++) {
        const VerificationCheck *check = &verification->checks[c];
        char question[CASES_TEXT_SIZE], limits[CASES_TEXT_SIZE], value[CASES_TEXT_SIZE];
        cases_text_question(check, question);
        cases_text_limits(check, limits);
        cases_text_value(check, value);
        printf("  ");
        print_column(question, 64);
        print_column(limits, 28);
        print_column(value, 20);
        printf("%s\n", cases_text_verdict(check->verdict));
    }
}

static void print_reasons(const Verification *verification) {
    for (size_t c = 0; c < verification->check_count; c++) {
        const VerificationCheck *check = &verification->checks[c];
        if (check->verdict != VERDICT_FAILED)
            continue;
        char question[CASES_TEXT_SIZE], why[3 * CASES_TEXT_SIZE];
        cases_text_question(check, question);
        cases_text_why(check, why);
        printf("not passed: %s (%s), %s: %s\n", verification->suite, verification->id, question, why);
    }
}

void cases_text_print(const Verification *cases, size_t count) {
    char summary[CASES_TEXT_SIZE];
    cases_text_summary(cases, count, summary);
    printf("  %-64s  %-28s  %-20s  %s\n", "test", "criterion", "ours", "passed");
    for (size_t i = 0; i < count; i++)
        print_case(&cases[i]);
    printf("\n%s\n", summary);
    for (size_t i = 0; i < count; i++)
        print_reasons(&cases[i]);
}

/* Markdown ----------------------------------------------------------------------------------------------------------*/

/* Adds a cell; line breaks and bars, which would end it, are replaced. */
static void add_cell(Text *text, const char *words) {
    text_add(text, "| ");
    for (const char *at = words; *at; at++) {
        char one[3] = {*at == '\n' ? ' ' : *at, 0, 0};
        if (*at == '|') {
            one[0] = '\\';
            one[1] = '|';
        }
        text_add(text, one);
    }
    text_add(text, " ");
}

static void add_check(Text *text, const Verification *verification, const VerificationCheck *check, bool first) {
    char name[2 * CASES_TEXT_SIZE], words[CASES_TEXT_SIZE], why[3 * CASES_TEXT_SIZE];
    snprintf(name, sizeof name, "**%.200s**: %.400s", verification->suite, verification->title);
    add_cell(text, first ? name : "");
    cases_text_question(check, words);
    add_cell(text, words);
    cases_text_limits(check, words);
    add_cell(text, words);
    cases_text_value(check, words);
    add_cell(text, words);
    if (check->verdict == VERDICT_FAILED) {
        snprintf(why, sizeof why, "**no**: %s%s%s", check->note, *check->note && *check->why ? "; " : "", check->why);
        add_cell(text, *check->note || *check->why ? why : "**no**");
    } else {
        add_cell(text, cases_text_verdict(check->verdict));
    }
    text_add(text, "|\n");
}

void cases_text_markdown(Text *text, const Verification *cases, size_t count, uint64_t seed) {
    char summary[CASES_TEXT_SIZE], line[CASES_TEXT_SIZE + 80];
    cases_text_summary(cases, count, summary);
    snprintf(line, sizeof line, "%s (`clearance cases`, seeds from %" PRIu64 ").\n\n", summary, seed);
    text_add(text, line);
    text_add(text, "| test | what is measured | criterion | ours | passed |\n|---|---|---|---|---|\n");
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < cases[i].check_count; c++)
            add_check(text, &cases[i], &cases[i].checks[c], c == 0);
    text_add(text, "\nThese do not apply:\n\n| test | why not |\n|---|---|\n");
    for (size_t i = 0; i < count; i++) {
        if (cases[i].applies)
            continue;
        char name[2 * CASES_TEXT_SIZE];
        snprintf(name, sizeof name, "**%.200s**: %.400s", cases[i].suite, cases[i].title);
        add_cell(text, name);
        add_cell(text, cases[i].reason);
        text_add(text, "|\n");
    }
}

/* JSON --------------------------------------------------------------------------------------------------------------*/

static json_t *number_or_null(double value) {
    return isfinite(value) ? json_real(round(value * 1e6) / 1e6) : json_null();
}

static json_t *answer_check(const VerificationCheck *check) {
    char question[CASES_TEXT_SIZE], why[3 * CASES_TEXT_SIZE];
    cases_text_question(check, question);
    cases_text_why(check, why);
    json_t *answer =
        json_pack("{s:s, s:s, s:o, s:o, s:s, s:i, s:o, s:s}", "measure", check->measure->name, "question", question,
                  "low", number_or_null(check->low), "high", number_or_null(check->high), "unit", check->unit, "seeds",
                  check->seeds, "value", number_or_null(check->value), "passed", cases_text_verdict(check->verdict));
    if (check->verdict == VERDICT_FAILED)
        json_object_set_new(answer, "why", json_string(why));
    return answer;
}

json_t *cases_text_json(const Verification *cases, size_t count, uint64_t seed) {
    char summary[CASES_TEXT_SIZE];
    cases_text_summary(cases, count, summary);
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++) {
        const Verification *verification = &cases[i];
        json_t *checks = json_array();
        for (size_t c = 0; c < verification->check_count; c++)
            json_array_append_new(checks, answer_check(&verification->checks[c]));
        json_t *answer = json_pack("{s:s, s:s, s:s, s:s, s:s, s:o}", "id", verification->id, "suite",
                                   verification->suite, "title", verification->title, "note", verification->note,
                                   "passed", cases_text_verdict(case_run_verdict(verification)), "checks", checks);
        if (!verification->applies)
            json_object_set_new(answer, "reason", json_string(verification->reason));
        json_array_append_new(list, answer);
    }
    return json_pack("{s:s, s:I, s:s, s:o}", "kind", "cases", "seed", (json_int_t)seed, "summary", summary, "cases",
                     list);
}
