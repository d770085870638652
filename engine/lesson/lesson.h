/* A lesson: a class predicts, watches, changes something and explains. A lesson file names a house, a beam or a crank
 * and lists steps; the goal of a task is a list of conditions on what the changed house does, which the program checks
 * on its own answer (condition.h, attempt.h).
 *
 * Who predicts first sees more of what happens (Crouch, Fagen, Callan and Mazur 2004; Miller, Lasry, Chu and Mazur
 * 2013), so a lesson asks before anything moves.
 *
 *     {"format": "clearance-lesson", "version": 1, "title": "...", "laboratory": "house", "minutes": 20,
 *      "level": "12 years and up", "file": "house.json", "set": "run.until=120", "script": "lesson.script",
 *      "learn": ["..."],
 *      "numbers": [{"name": "wide", "set": "door.d3.width=0.9", "measure": "time", "unit": "s", "digits": 1}],
 *      "steps": [{"kind": "predict", "ask": "Does the driver get out?", "options": ["yes", "no"], "truth": 2}, ...],
 *      "pictures": [{"caption": "...", "set": "..."}],
 *      "teacher": {"before": ["..."], "questions": ["..."], "mistakes": ["..."]}}
 *
 * A text may hold numbers by their names, "out in {wide}": the program fills them in (words.h). It may be in several
 * languages, {"en": "...", "ja": "..."} (language.h). */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "inquiry/condition.h"

typedef enum LessonLaboratory { LESSON_HOUSE, LESSON_BEAM, LESSON_CRANK } LessonLaboratory;

typedef enum LessonKind {
    LESSON_READ,
    LESSON_PREDICT,  /* options, before anything is shown */
    LESSON_OBSERVE,  /* plays, then asks what was seen */
    LESSON_TASK,     /* has a goal */
    LESSON_EXPLAIN,  /* free words, then a model answer */
    LESSON_COMPARE,  /* the guesses of the class and the result */
    LESSON_TRANSFER, /* another situation with the same idea */
    LESSON_KINDS,
} LessonKind;

enum { LESSON_OPTIONS_MOST = 9, LESSON_HINTS = 3, LESSON_STEPS_MOST = 20 };

typedef struct LessonTexts {
    const char **at; /* (count) */
    size_t count;
} LessonTexts;

/* A condition of a goal. With `than` its value is the ratio to the same measure with these settings added. */
typedef struct LessonGoal {
    Condition condition;
    const char *than; /* "NAME=VALUE NAME=VALUE ...", or "" */
    const char *is;   /* name of the thing that must be selected, or "" */
} LessonGoal;

/* A number that the program computes for the texts, at the beginning of the lesson with these settings added. */
typedef struct LessonNumber {
    const char *name;
    const char *set;     /* settings, or "" */
    const char *than;    /* as of a goal, or "" */
    Condition condition; /* its measure and unit; limits within which right options and texts hold, or none */
    int digits;          /* behind the point */
} LessonNumber;

/* A table to fill in: the sheet for pupils shows no cell that holds a number of the program. */
typedef struct LessonTable {
    LessonTexts head;
    LessonTexts *rows; /* (row_count) as many cells as the head has */
    size_t row_count;
} LessonTable;

/* The layers, plots and speed of the window: see look.h. */
typedef struct LessonLook {
    bool layered;      /* the layers are given */
    unsigned layers;   /* their bits */
    const char *plots; /* names, separated by commas; "none"; "": not given */
    double speed;      /* of playback; 0: not given */
} LessonLook;

typedef struct LessonStep {
    int kind;            /* LessonKind */
    const char *text;    /* or "" */
    const char *ask;     /* question, or "" */
    const char *model;   /* model answer, or "" */
    const char *done;    /* said when the goal is reached, or "" */
    const char *set;     /* settings with which the step begins, "" as the lesson */
    int truth;           /* right option, from 1; 0: none */
    const char *unit;    /* of a guess that is a number, 1 of one without; "": the guess is an option */
    double answer;       /* to it, in the unit; HUGE_VAL: none */
    double speed;        /* of playback when it is watched; else that of its look, 1 */
    double from;         /* s, time from which it is watched */
    int minutes;         /* that a class needs for it; 0: not said */
    LessonTexts options; /* at most LESSON_OPTIONS_MOST */
    LessonTexts wrong;   /* what is said to each option that is wrong; "" to the right one; or none */
    LessonTexts hints;   /* LESSON_HINTS, or none */
    LessonTexts mark;    /* names of things that have a frame in the view: see names.h */
    const char *show;    /* name of the thing that the view shows near, or "" */
    LessonLook view;
    LessonGoal *goals; /* (goal_count) all of them must hold */
    size_t goal_count;
    LessonTable table;
} LessonStep;

/* A picture of a result on the sheet with answers. */
typedef struct LessonPicture {
    const char *caption;
    const char *set;
} LessonPicture;

typedef struct Lesson {
    const char *path; /* of the lesson file */
    const char *title;
    int laboratory; /* LessonLaboratory */
    int minutes;
    const char *level;
    const char *file;   /* path of the house, beam or crank */
    const char *set;    /* settings, or "" */
    const char *script; /* path of the script that tries the lesson */
    LessonLook view;
    bool names; /* each piece of a house has its name in the view, within it or next to it */
    LessonTexts learn;
    LessonTexts lock;        /* what a class may not change: lists of the house, "walls", or numbers of the machine */
    LessonNumber *numbers;   /* (number_count) */
    LessonStep *steps;       /* (step_count) */
    LessonPicture *pictures; /* (picture_count) */
    size_t number_count, step_count, picture_count;
    LessonTexts before, questions, mistakes; /* the teacher's */
    Arena arena;
} Lesson;

/* Reads a lesson file and checks it against its house, beam or crank. Returns false after an error, with the lesson
 * unchanged; lesson_free releases it. */
bool lesson_read(Lesson *lesson, const char *path, Fault *fault);
void lesson_free(Lesson *lesson);

/* Returns "predict", and what a class is told that it does: "Your guess first". */
const char *lesson_kind_word(LessonKind kind);
const char *lesson_kind_title(LessonKind kind);

enum { LESSON_SETTINGS_MOST = 256 };

/* Splits "NAME=VALUE NAME=VALUE ..." and adds the settings, whose texts live in the arena, to the first `count` of
 * `settings` (LESSON_SETTINGS_MOST); those without room are left out. Returns the new number. */
size_t lesson_add_settings(const char *set, const char **settings, size_t count, Arena *arena);

/* Returns the JSON Schema (2020-12) of a lesson file; new, json_decref it. */
json_t *lesson_schema(void);
