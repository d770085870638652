/* The table of verification cases as text: its sentences; for a terminal, as Markdown, as JSON. */
#pragma once

#include <jansson.h>
#include <stddef.h>
#include <stdint.h>

#include "base/text.h"
#include "inquiry/verification.h"

enum { CASES_TEXT_SIZE = 320 /* characters of the longest of these texts */ };

/* Returns the answer to "passed?": "yes", "no", "does not apply" or "not run". */
const char *cases_text_verdict(Verdict verdict);

/* Writes the question of a check: its title, or the meaning of its measure with the people and the exit. */
void cases_text_question(const VerificationCheck *check, char text[CASES_TEXT_SIZE]);

/* Writes the limits: "26 to 34 s", "at most 1.33 persons/(m s)", "exactly 23". */
void cases_text_limits(const VerificationCheck *check, char text[CASES_TEXT_SIZE]);

/* Writes the value: "31.2 s", or "-" if there is none. */
void cases_text_value(const VerificationCheck *check, char text[CASES_TEXT_SIZE]);

/* Writes why a check is not passed: the value and its limits, the note of the measure, the reason in the case. */
void cases_text_why(const VerificationCheck *check, char text[3 * CASES_TEXT_SIZE]);

/* Writes the summary: "24 of 27 tests passed, 3 did not; 9 do not apply". */
void cases_text_summary(const Verification *cases, size_t count, char text[CASES_TEXT_SIZE]);

/* Prints the table on standard output, and below it the reasons of failed checks. */
void cases_text_print(const Verification *cases, size_t count);

/* Adds the same as a Markdown table. */
void cases_text_markdown(Text *text, const Verification *cases, size_t count, uint64_t seed);

/* Returns a new {"kind":"cases","seed":..,"cases":[{"id","suite","title","note","passed","checks":[..]}]}. */
json_t *cases_text_json(const Verification *cases, size_t count, uint64_t seed);
