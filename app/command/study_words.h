/* The answer of a study in words, with a small table. */
#pragma once

#include "command/study_laboratory.h"
#include "study/study.h"

void study_words_print(const Study *study, const StudyLaboratory *laboratory, const char *file);
