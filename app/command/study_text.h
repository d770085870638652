/* The answer of a study as text: sentences, and a table or a map in letters below them. */
#pragma once

#include "command/study_laboratory.h"
#include "study/study.h"

/* Prints the answer on standard output. */
void study_text_print(const Study *study, const StudyLaboratory *laboratory, const char *file);
