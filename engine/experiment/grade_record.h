/* The record of the grade of each run of a house in which all people are out, if they are few (grade_answer): one
 * observable, the worst grade of those who drive, and a note, its place. Who drives and how the motion is computed do
 * not change the house, nor does the seed without a crowd, so that such runs have one grade, worked out once. */
#pragma once

#include "house/house.h"
#include "house/observation.h"
#include "study/experiment.h"

typedef struct GradeRecord GradeRecord;

/* Creates a record behind the first `usual` observables. grade_record_free releases it and accepts NULL. */
GradeRecord *grade_record_create(size_t few, size_t usual);
void grade_record_free(GradeRecord *record);

/* Describes the observable, whose values are grades (grade_letter). */
Observable grade_record_describe(void);

/* Fills the observable and the note of a run of `house`, whose varied `names` have the values of the trial. Any number
 * of threads may fill runs at once. Returns false if interrupted. */
bool grade_record_observe(GradeRecord *record, const House *house, const Observation *observation,
                          const char *const *names, size_t name_count, Trial *trial, const Stop *stop);
