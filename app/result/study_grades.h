/* The grades of a study of a house: the worst one of the people of each point whose runs have one. */
#pragma once

#include "base/text.h"
#include "result/result.h"
#include "study/study.h"

/* Returns the letter of a point, or NULL: nobody is out there, nobody has a grade, or the study is not graded. */
const char *study_grades_letter(const Study *study, size_t i1, size_t i0);

/* True if any point has a grade. */
bool study_grades_exist(const Study *study);

/* A record for each point that has a grade: its values, the grade and its place. */
ResultTable study_grades_table(const Study *study);

/* A record for each range of neighbouring values of the only axis with one grade. */
ResultTable study_grades_ranges(const Study *study);

/* Adds a line: "grade D, at door d3, from 0.82 to 0.86 m; grade C, at door d6, from 0.87 m on"; nothing without grades.
 */
void study_grades_say(Text *text, const Study *study);
