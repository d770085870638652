/* The rows of verification cases: the terminal, Markdown, the page and JSON print the same facts. */
#include "check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command/cases_html.h"
#include "result/cases_text.h"
#include "result/cases.h"

static const Measure time_of = {.name = "time", .meaning = "time"};

/* One case with a check that passed and one that failed, and one that does not apply. */
typedef struct Sample {
    VerificationCheck checks[2];
    Verification cases[2];
} Sample;

static VerificationCheck make_check(double low, double high, double value, Verdict verdict) {
    VerificationCheck check = {.condition = {.title = "",
                                             .question = {.exit = ""},
                                             .low = low,
                                             .high = high,
                                             .unit = "s",
                                             .why = "",
                                             .measure = &time_of,
                                             .verdict = verdict,
                                             .value = value},
                               .variant = "",
                               .than = "",
                               .seeds = 1};
    return check;
}

static void make_sample(Sample *sample) {
    sample->checks[0] = make_check(26, 34, 31.25, VERDICT_PASSED);
    sample->checks[1] = make_check(-HUGE_VAL, 12, NAN, VERDICT_FAILED);
    sample->checks[1].condition.question.exit = "e1";
    sample->checks[1].than = "wide";
    sample->checks[1].is_ratio = true;
    sample->checks[1].condition.why = "a | b";
    strcpy(sample->checks[1].condition.note, "nobody is out");
    sample->cases[0] = (Verification){.id = "x-1",
                                      .suite = "X 1",
                                      .title = "a corridor",
                                      .note = "",
                                      .applies = true,
                                      .checks = sample->checks,
                                      .check_count = 2};
    sample->cases[1] =
        (Verification){.id = "x-2", .suite = "X 2", .title = "stairs", .note = "", .reason = "one storey"};
}

TEST(a_check_says_its_question_its_criterion_its_value_and_why_it_failed) {
    Sample sample;
    make_sample(&sample);
    ResultTable checks = result_cases_checks(&sample.cases[0]);
    CHECK_TEXT(result_at(&checks, 0, CHECK_QUESTION)->text, "time");
    CHECK_TEXT(result_at(&checks, 0, CHECK_CRITERION)->text, "26 to 34 s");
    CHECK_TEXT(result_at(&checks, 0, CHECK_VALUE)->text, "31.25 s");
    CHECK_TEXT(result_at(&checks, 0, CHECK_PASSED)->text, "yes");
    CHECK(result_at(&checks, 0, CHECK_WHY)->omitted);
    CHECK_TEXT(result_at(&checks, 1, CHECK_QUESTION)->text, "ratio: time, exit e1, against wide");
    CHECK_TEXT(result_at(&checks, 1, CHECK_CRITERION)->text, "at most 12 s");
    CHECK(!result_at(&checks, 1, CHECK_VALUE)->text);
    CHECK_TEXT(result_at(&checks, 1, CHECK_WHY)->text, "no value, must be at most 12 s; nobody is out; a | b");
    result_clear(&checks);
}

TEST(a_case_is_the_same_in_markdown_on_the_page_and_in_json) {
    Sample sample;
    Text markdown = {0}, page = {0};
    make_sample(&sample);
    cases_text_markdown(&markdown, sample.cases, 2, 1);
    CHECK_TEXT(markdown.text,
               "0 of 1 tests passed, 1 did not; 1 does not apply (`clearance cases`, seeds from 1).\n\n"
               "| test | what is measured | criterion | ours | passed |\n|---|---|---|---|---|\n"
               "| **X 1**: a corridor | time | 26 to 34 s | 31.25 s | yes |\n"
               "|  | ratio: time, exit e1, against wide | at most 12 s | - | **no**: nobody is out; a \\| b "
               "|\n\nThese do not apply:\n\n| test | why not |\n|---|---|\n| **X 2**: stairs | one storey "
               "|\n");
    cases_html_add(&page, sample.cases, 2, 1);
    static const char *const parts[] = {"<td>26 to 34 s</td>", "31.25 s", "nobody is out; a | b", "<b>X 2</b> stairs"};
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        CHECK(strstr(page.text, parts[p]));
    json_t *answer = cases_text_json(sample.cases, 2, 1);
    char *dump = json_dumps(json_object_get(answer, "cases"), JSON_COMPACT);
    CHECK_TEXT(
        dump, "[{\"id\":\"x-1\",\"suite\":\"X 1\",\"title\":\"a corridor\",\"note\":\"\",\"passed\":\"no\",\"checks\":["
              "{\"measure\":\"time\",\"question\":\"time\",\"low\":26.0,\"high\":34.0,\"unit\":\"s\",\"seeds\":1,"
              "\"value\":31.25,\"passed\":\"yes\"},{\"measure\":\"time\",\"question\":\"ratio: time, exit e1, against "
              "wide\",\"low\":null,\"high\":12.0,\"unit\":\"s\",\"seeds\":1,\"value\":null,\"passed\":\"no\",\"why\":"
              "\"no value, must be at most 12 s; nobody is out; a | b\"}]},{\"id\":\"x-2\",\"suite\":\"X 2\",\"title\":"
              "\"stairs\",\"note\":\"\",\"passed\":\"does not apply\",\"checks\":[],\"reason\":\"one storey\"}]");
    free(dump);
    json_decref(answer);
    memory_free(markdown.text);
    memory_free(page.text);
}
