#include "command/cases_table.h"

#include <inttypes.h>
#include <stdio.h>

#include "command/cases_words.h"
#include "inquiry/case_run.h"

/* Terminal ----------------------------------------------------------------------------------------------------------*/

/* A column of `width` characters, of which UTF-8 may need more bytes than one each. */
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
        char question[CASES_WORDS_SIZE], limits[CASES_WORDS_SIZE], value[CASES_WORDS_SIZE];
        cases_words_question(check, question);
        cases_words_limits(check, limits);
        cases_words_value(check, value);
        printf("  ");
        print_column(question, 64);
        print_column(limits, 28);
        print_column(value, 20);
        printf("%s\n", cases_words_verdict(check->verdict));
    }
}

static void print_reasons(const Verification *verification) {
    for (size_t c = 0; c < verification->check_count; c++) {
        const VerificationCheck *check = &verification->checks[c];
        if (check->verdict != VERDICT_FAILED)
            continue;
        char question[CASES_WORDS_SIZE], why[3 * CASES_WORDS_SIZE];
        cases_words_question(check, question);
        cases_words_why(check, why);
        printf("not passed: %s (%s), %s: %s\n", verification->suite, verification->id, question, why);
    }
}

void cases_table_print(const Verification *cases, size_t count) {
    char summary[CASES_WORDS_SIZE];
    cases_words_summary(cases, count, summary);
    printf("  %-64s  %-28s  %-20s  %s\n", "test", "criterion", "ours", "passed");
    for (size_t i = 0; i < count; i++)
        print_case(&cases[i]);
    printf("\n%s\n", summary);
    for (size_t i = 0; i < count; i++)
        print_reasons(&cases[i]);
}

/* Markdown ----------------------------------------------------------------------------------------------------------*/

/* A cell: what would end it is replaced. */
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
    char name[2 * CASES_WORDS_SIZE], words[CASES_WORDS_SIZE], why[3 * CASES_WORDS_SIZE];
    snprintf(name, sizeof name, "**%.200s**: %.400s", verification->suite, verification->title);
    add_cell(text, first ? name : "");
    cases_words_question(check, words);
    add_cell(text, words);
    cases_words_limits(check, words);
    add_cell(text, words);
    cases_words_value(check, words);
    add_cell(text, words);
    if (check->verdict == VERDICT_FAILED) {
        snprintf(why, sizeof why, "**no**: %s%s%s", check->note, *check->note && *check->why ? "; " : "", check->why);
        add_cell(text, *check->note || *check->why ? why : "**no**");
    } else {
        add_cell(text, cases_words_verdict(check->verdict));
    }
    text_add(text, "|\n");
}

void cases_table_markdown(Text *text, const Verification *cases, size_t count, uint64_t seed) {
    char summary[CASES_WORDS_SIZE], line[CASES_WORDS_SIZE + 80];
    cases_words_summary(cases, count, summary);
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
        char name[2 * CASES_WORDS_SIZE];
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
    char question[CASES_WORDS_SIZE], why[3 * CASES_WORDS_SIZE];
    cases_words_question(check, question);
    cases_words_why(check, why);
    json_t *answer =
        json_pack("{s:s, s:s, s:o, s:o, s:s, s:i, s:o, s:s}", "measure", check->measure->name, "question", question,
                  "low", number_or_null(check->low), "high", number_or_null(check->high), "unit", check->unit, "seeds",
                  check->seeds, "value", number_or_null(check->value), "passed", cases_words_verdict(check->verdict));
    if (check->verdict == VERDICT_FAILED)
        json_object_set_new(answer, "why", json_string(why));
    return answer;
}

json_t *cases_table_json(const Verification *cases, size_t count, uint64_t seed) {
    char summary[CASES_WORDS_SIZE];
    cases_words_summary(cases, count, summary);
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++) {
        const Verification *verification = &cases[i];
        json_t *checks = json_array();
        for (size_t c = 0; c < verification->check_count; c++)
            json_array_append_new(checks, answer_check(&verification->checks[c]));
        json_t *answer = json_pack("{s:s, s:s, s:s, s:s, s:s, s:o}", "id", verification->id, "suite",
                                   verification->suite, "title", verification->title, "note", verification->note,
                                   "passed", cases_words_verdict(case_run_verdict(verification)), "checks", checks);
        if (!verification->applies)
            json_object_set_new(answer, "reason", json_string(verification->reason));
        json_array_append_new(list, answer);
    }
    return json_pack("{s:s, s:I, s:s, s:o}", "kind", "cases", "seed", (json_int_t)seed, "summary", summary, "cases",
                     list);
}
