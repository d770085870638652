/* What checks ask, allow and found, in words. */
#pragma once

#include <stddef.h>

#include "inquiry/verification.h"

enum { CASES_WORDS_SIZE = 320 /* characters of the longest of these texts */ };

/* "yes", "no", "does not apply", "not run": the answers to "passed?". */
const char *cases_words_verdict(Verdict verdict);

/* What is asked: the check's title or the measure's meaning, of whom and where. */
void cases_words_question(const VerificationCheck *check, char text[CASES_WORDS_SIZE]);

/* "26 to 34 s", "at most 1.33 persons/(m s)", "exactly 23". */
void cases_words_limits(const VerificationCheck *check, char text[CASES_WORDS_SIZE]);

/* "31.2 s", or "-" when there is no value. */
void cases_words_value(const VerificationCheck *check, char text[CASES_WORDS_SIZE]);

/* Why a check is not passed: the value and its limit, what the measure says, what the case says. */
void cases_words_why(const VerificationCheck *check, char text[3 * CASES_WORDS_SIZE]);

/* "24 of 27 tests passed, 3 did not; 9 do not apply". */
void cases_words_summary(const Verification *cases, size_t count, char text[CASES_WORDS_SIZE]);
