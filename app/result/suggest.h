/* The smallest changes that let all people out as rows, for `check --suggest`, its JSON and the window's list. */
#pragma once

#include "inquiry/suggest.h"
#include "result/result.h"
#include "rules/rule_set.h"

/* A record for each suggestion, the smallest change first, with what each set of `payers` (NULL: none) says about
 * paying for it. The list must outlive the table. */
ResultTable result_suggest_changes(const SuggestList *list, const RuleSets *payers);

/* Returns "Smallest changes that let all people out", or why none is listed. */
const char *result_suggest_sentence(const SuggestList *list, Arena *arena);

/* Returns how many houses were tried, and whether there may be other changes. */
const char *result_suggest_tried(const SuggestList *list, Arena *arena);

/* Returns "all people are out in 26.1 s". */
const char *result_suggest_outcome(const Suggestion *suggestion, Arena *arena);
