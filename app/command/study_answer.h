/* The answer of a study, as JSON (the contract). */
#pragma once

#include <jansson.h>

#include "study/study.h"

/* {"kind":"study", ...}. New; json_decref it. */
json_t *study_answer_make(const Study *study, const char *file);
