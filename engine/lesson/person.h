/* Conditions on what a person has done, which no run shows:
 *
 *     {"measure": "answer", "unit": "1", "is": 2}                 the guess of the last step "predict"
 *     {"measure": "selected", "unit": "1", "is": "door d3"}       the thing that is selected, by its name (names.h) */
#pragma once

#include "lesson/lesson.h"

struct Names;

typedef struct PersonState {
    double answer;        /* option, from 1, or number of the last step "predict"; NAN: none */
    const char *selected; /* name of the thing that is selected; NULL: nothing */
} PersonState;

/* True if a measure is one of these. */
bool person_has(const char *measure);

/* Reads "is" of a condition of the goal of this step, at the node: a number stands for both limits, a name is that of
 * the thing; then checks a condition on a person. `names` NULL: the lesson's file was not read. */
void person_read(LessonGoal *goal, Lesson *lesson, const LessonStep *step, const struct Names *names,
                 const JsonNode *node, Fault *fault);

/* Returns the value: of "selected" 1 if that thing is selected, else 0. */
double person_value(const LessonGoal *goal, const PersonState *state);
