/* The small tables below the answer of a study in words. */
#pragma once

#include "command/study_laboratory.h"
#include "study/study.h"

/* Of one axis: a dozen of its values. */
void study_table_print(const Study *study, const StudyLaboratory *laboratory);

/* Of two axes, in letters, the second upwards; of a large one every so many values. */
void study_table_map(const Study *study, const StudyLaboratory *laboratory, size_t pass);

/* Of many runs without an axis: each observable as a distribution. */
void study_table_distributions(const Study *study, const StudyLaboratory *laboratory);
