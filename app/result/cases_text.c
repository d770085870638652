#include "result/cases_text.h"

#include <inttypes.h>
#include <stdio.h>

#include "result/cases.h"
#include "result/json.h"

static const char *text_of(const ResultTable *table, size_t record, size_t row) {
    return result_at(table, record, row)->text;
}

/* Terminal ----------------------------------------------------------------------------------------------------------*/

/* Prints a column of `width` characters, each of which may be several bytes of UTF-8. */
static void print_column(const char *words, int width) {
    for (const char *at = words; *at; at++)
        width -= ((unsigned char)*at & 0xc0) != 0x80;
    printf("%s%*s  ", words, width > 0 ? width : 0, "");
}

static void print_case(const Verification *verification) {
    ResultTable checks = result_cases_checks(verification);
    printf("%s: %s\n", verification->suite, verification->title);
    if (!verification->applies)
        printf("  does not apply: %s\n", verification->reason);
    for (size_t c = 0; c < checks.record_count; c++) {
        const char *value = text_of(&checks, c, CHECK_VALUE);
        printf("  ");
        print_column(text_of(&checks, c, CHECK_QUESTION), 64);
        print_column(text_of(&checks, c, CHECK_CRITERION), 28);
        print_column(value ? value : "-", 20);
        printf("%s\n", text_of(&checks, c, CHECK_PASSED));
    }
    result_clear(&checks);
}

static void print_reasons(const Verification *verification) {
    ResultTable checks = result_cases_checks(verification);
    for (size_t c = 0; c < checks.record_count; c++)
        if (verification->checks[c].condition.verdict == VERDICT_FAILED)
            printf("not passed: %s (%s), %s: %s\n", verification->suite, verification->id,
                   text_of(&checks, c, CHECK_QUESTION), text_of(&checks, c, CHECK_WHY));
    result_clear(&checks);
}

void cases_text_print(const Verification *cases, size_t count) {
    Arena arena = {0};
    printf("  %-64s  %-28s  %-20s  %s\n", "test", "criterion", "ours", "passed");
    for (size_t i = 0; i < count; i++)
        print_case(&cases[i]);
    printf("\n%s\n", result_cases_summary(cases, count, &arena));
    for (size_t i = 0; i < count; i++)
        print_reasons(&cases[i]);
    arena_clear(&arena);
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

static void add_name(Text *text, const char *suite, const char *title) {
    Arena arena = {0};
    add_cell(text, text_in_arena(&arena, "**%s**: %s", suite, title));
    arena_clear(&arena);
}

static void add_verdict(Text *text, const ResultTable *checks, size_t c) {
    const ResultRow *reason = result_at(checks, c, CHECK_REASON);
    Arena arena = {0};
    const char *passed = text_of(checks, c, CHECK_PASSED);
    if (!reason->omitted)
        passed = *reason->text ? text_in_arena(&arena, "**%s**: %s", passed, reason->text)
                               : text_in_arena(&arena, "**%s**", passed);
    add_cell(text, passed);
    arena_clear(&arena);
}

static void add_checks(Text *text, const Verification *verification) {
    ResultTable checks = result_cases_checks(verification);
    for (size_t c = 0; c < checks.record_count; c++) {
        const char *value = text_of(&checks, c, CHECK_VALUE);
        if (c == 0)
            add_name(text, verification->suite, verification->title);
        else
            add_cell(text, "");
        add_cell(text, text_of(&checks, c, CHECK_QUESTION));
        add_cell(text, text_of(&checks, c, CHECK_CRITERION));
        add_cell(text, value ? value : "-");
        add_verdict(text, &checks, c);
        text_add(text, "|\n");
    }
    result_clear(&checks);
}

void cases_text_markdown(Text *text, const Verification *cases, size_t count, uint64_t seed) {
    Arena arena = {0};
    ResultTable excluded = result_cases_excluded(cases, count);
    text_format(text, "%s (`clearance cases`, seeds from %" PRIu64 ").\n\n", result_cases_summary(cases, count, &arena),
                seed);
    text_add(text, "| test | what is measured | criterion | ours | passed |\n|---|---|---|---|---|\n");
    for (size_t i = 0; i < count; i++)
        add_checks(text, &cases[i]);
    text_add(text, "\nThese do not apply:\n\n| test | why not |\n|---|---|\n");
    for (size_t i = 0; i < excluded.record_count; i++) {
        add_name(text, text_of(&excluded, i, EXCLUDED_SUITE), text_of(&excluded, i, EXCLUDED_TITLE));
        add_cell(text, text_of(&excluded, i, EXCLUDED_REASON));
        text_add(text, "|\n");
    }
    result_clear(&excluded);
    arena_clear(&arena);
}

/* JSON --------------------------------------------------------------------------------------------------------------*/

static json_t *checks_json(const Verification *verification) {
    ResultTable checks = result_cases_checks(verification);
    json_t *list = result_json_list(&checks);
    result_clear(&checks);
    return list;
}

json_t *cases_text_json(const Verification *cases, size_t count, uint64_t seed) {
    Arena arena = {0};
    ResultTable all = result_cases_list(cases, count), excluded = result_cases_excluded(cases, count);
    json_t *list = result_json_list(&all);
    for (size_t i = 0, e = 0; i < count; i++) {
        json_object_set_new(json_array_get(list, i), "checks", checks_json(&cases[i]));
        if (!cases[i].applies)
            result_json_add(json_array_get(list, i), &excluded, e++);
    }
    json_t *answer = json_pack("{s:s, s:I, s:s, s:o}", "kind", "cases", "seed", (json_int_t)seed, "summary",
                               result_cases_summary(cases, count, &arena), "cases", list);
    result_clear(&all);
    result_clear(&excluded);
    arena_clear(&arena);
    return answer;
}
