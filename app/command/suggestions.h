/* The smallest changes that let all people out, for `check --suggest`. */
#pragma once

#include <jansson.h>

#include "options/options.h"
#include "inquiry/suggest.h"

/* Looks for them, with progress on standard error when that is wanted. False: faults say why not. */
bool suggestions_find(SuggestList *list, const Options *options, Fault *fault);

/* Adds "suggestions", and "suggestion_notes" about what was tried, to the answer of a check. */
void suggestions_add(json_t *answer, const SuggestList *list);
void suggestions_print(const SuggestList *list);
