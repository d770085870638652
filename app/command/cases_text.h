/* The table of verification cases as text: its sentences; for a terminal, as Markdown, as JSON. */
#pragma once

#include <jansson.h>
#include <stddef.h>
#include <stdint.h>

#include "base/text.h"
#include "inquiry/verification.h"

enum { CASES_TEXT_SIZE = 320 /* characters of the longest of these texts */ };

/* "yes", "no", "does not apply", "not run": the answers to "passed?". */
const char *cases_text_verdict(Verdict verdict);

/* What is asked: the check's title or the measure's meaning, of whom and where. */
void cases_text_question(const VerificationCheck *check, char text[CASES_TEXT_SIZE]);

/* "26 to 34 s", "at most 1.33 persons/(m s)", "exactly 23". */
void cases_text_limits(const VerificationCheck *check, char text[CASES_TEXT_SIZE]);

/* "31.2 s", or "-" when there is no value. */
void cases_text_value(const VerificationCheck *check, char text[CASES_TEXT_SIZE]);

/* Why a check is not passed: the value and its limit, what the measure says, what the case says. */
void cases_text_why(const VerificationCheck *check, char text[3 * CASES_TEXT_SIZE]);

/* "24 of 27 tests passed, 3 did not; 9 do not apply". */
void cases_text_summary(const Verification *cases, size_t count, char text[CASES_TEXT_SIZE]);

/* Prints the table on standard output, and below it why checks are not passed. */
void cases_text_print(const Verification *cases, size_t count);

/* Adds the same as a Markdown table. */
void cases_text_markdown(Text *text, const Verification *cases, size_t count, uint64_t seed);

/* {"kind":"cases","seed":..,"cases":[{"id","suite","title","note","passed","checks":[..]}]}. New. */
json_t *cases_text_json(const Verification *cases, size_t count, uint64_t seed);
