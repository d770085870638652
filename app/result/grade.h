/* The grade of an answer: nobody is said to get out without it. */
#pragma once

#include "base/text.h"
#include "inquiry/grade.h"

/* Returns "at door d3" or "at the start, beside wall w1" for the place of a grade, in the arena. */
const char *result_grade_place(const char *what, Arena *arena);

/* Returns "grade D", "worst grade B, with care, at door d7" if there are several people, "grade E, helper only, driver
 * too weak", in the arena; "": no grade is known. */
const char *result_grade_phrase(const House *house, const Grade *grades, Arena *arena);

/* Adds the worst grade to the title and the detail of an answer: "Out in 23.0 s, grade D" and "touching likely;
 * narrowest 0.007 m at door d3". They stay as they are if no grade is known. Without `grades` (NULL), which are being
 * worked out, only the detail says so, if anybody drives. */
void result_grade_add(const char **title, const char **detail, const House *house, const Grade *grades, Arena *arena);
