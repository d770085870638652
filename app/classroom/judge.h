/* Judges goals and computes the numbers of a lesson, each on a thread, so that the window never waits. A verdict
 * belongs to the state that it was asked for; the answer for an older state is given up. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "lesson/person.h"

typedef struct Judge Judge;

/* Begins to compute the numbers of the lesson at this path, which can be read; `profiles` as in attempt.h, kept by the
 * caller. NULL: the system has no more threads. judge_destroy ends the work. */
Judge *judge_create(const char *path, const char *profiles, int jobs);
void judge_destroy(Judge *judge);

/* The goal of a step in a state. */
typedef struct JudgeQuestion {
    size_t step;                                /* from 0 */
    uint64_t state;                             /* digest of all that follows, and of the step */
    const char *text;                           /* of a house, as file text; NULL: see attempt.h */
    const char *settings[LESSON_SETTINGS_MOST]; /* (count) NAME=VALUE */
    size_t count;
    PersonState person;
} JudgeQuestion;

/* Asks a question, whose texts are copied. Work on an earlier one ends. */
void judge_ask(Judge *judge, const JudgeQuestion *question);

/* Says what judge_take has copied. */
typedef struct JudgeNews {
    bool judged;   /* the goals of `step` in the state `state` */
    bool counted;  /* numbers of the texts, which come one by one */
    bool numbered; /* all of them are known */
    size_t step;   /* from 0 */
    uint64_t state;
} JudgeNews;

/* Takes over finished work into `lesson`, the caller's copy. What cannot be run leaves its goals without verdicts and a
 * reason in `fault`. */
JudgeNews judge_take(Judge *judge, Lesson *lesson, Fault *fault);
