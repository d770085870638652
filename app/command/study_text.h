/* The answer of a study as text: sentences, and a table or a map in letters below them. */
#pragma once

#include "base/text.h"
#include "study/study.h"

/* Adds the answer. */
void study_text_add(Text *text, const Study *study, const char *file);
