/* The facts of verification cases as rows, for `cases`: on the terminal, as a page, as Markdown and as JSON. */
#pragma once

#include "inquiry/verification.h"
#include "result/result.h"

/* Rows of a case. */
typedef enum CaseRow { CASE_ID, CASE_SUITE, CASE_TITLE, CASE_NOTE, CASE_PASSED } CaseRow;

/* A record for each case. The cases must outlive the tables. */
ResultTable result_cases_list(const Verification *cases, size_t count);

/* Rows of a case that does not apply. */
typedef enum ExcludedRow { EXCLUDED_SUITE, EXCLUDED_TITLE, EXCLUDED_REASON } ExcludedRow;

/* A record for each case that does not apply. */
ResultTable result_cases_excluded(const Verification *cases, size_t count);

/* Rows of a check. */
typedef enum CheckRow {
    CHECK_MEASURE,
    CHECK_QUESTION, /* its title, or the meaning of its measure with the people and the exit */
    CHECK_LOW,
    CHECK_HIGH,
    CHECK_UNIT,
    CHECK_CRITERION, /* "26 to 34 s", "at most 1.33 persons/(m s)", "exactly 23" */
    CHECK_SEEDS,
    CHECK_VALUE,  /* "31.2 s"; none where there is no number */
    CHECK_PASSED, /* "yes", "no", "does not apply", "not run" */
    CHECK_REASON, /* of a failed check: the note of the measure and the reason in the case */
    CHECK_WHY,    /* of a failed check: the value, its limits and the reason */
} CheckRow;

/* A record for each check of a case. */
ResultTable result_cases_checks(const Verification *verification);

/* Returns the summary: "24 of 27 tests passed, 3 did not; 9 do not apply". It lives as long as the arena. */
const char *result_cases_summary(const Verification *cases, size_t count, Arena *arena);
