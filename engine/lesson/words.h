/* Numbers in the texts of a lesson: "out in {wide}" becomes "out in 18.7 s". They are filled in by the program, never
 * typed. */
#pragma once

#include "lesson/lesson.h"

/* Returns the text with its numbers in the arena; in the place of one that is not known yet it says so. */
const char *words_fill(const Lesson *lesson, const char *text, Arena *arena);

/* Returns the name of the first number in the text that the lesson does not have, in the arena; NULL: it has all. */
const char *words_unknown(const Lesson *lesson, const char *text, Arena *arena);

/* True if the text holds a number of the program. */
bool words_has_number(const char *text);

/* Returns a value with its unit, "18.7 s", "2", in the arena; digits negative: as few as tell 4 places. */
const char *words_value(double value, int digits, const char *unit, Arena *arena);

/* Returns a goal's result in words, "doors wider: 0.08 m, at most 0.10 m", in the arena. */
const char *words_goal(const LessonGoal *goal, Arena *arena);

/* Returns its limits in words, "at most 0.10 m", in the arena. */
const char *words_limits(const LessonGoal *goal, Arena *arena);
