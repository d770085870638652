/* The answer of a study in words, with a small table. */
#pragma once

#include "command/study_laboratory.h"
#include "study/study.h"
#include "study/summary.h"

enum { STUDY_WORDS_WORD = 48 /* characters of a number with its unit */ };

void study_words_print(const Study *study, const StudyLaboratory *laboratory, const char *file);

/* A number that was observed; "-" for none. */
void study_words_number(double number, char word[STUDY_WORDS_WORD]);

/* The i-th value of an axis, with as many digits as tell it from its neighbours: "0.84 m", small ones in mm and ms. */
void study_words_step(const Study *study, size_t axis, size_t i, bool with_unit, char word[STUDY_WORDS_WORD]);

/* Their unit, and an observable's; "" for pure numbers. */
const char *study_words_axis_unit(const Study *study, size_t axis);
const char *study_words_unit(const Observable *observable);

/* "out", "not out", "sometimes out", "cannot be told", "not run" */
const char *study_words_state(const StudyLaboratory *laboratory, SummaryState state);
