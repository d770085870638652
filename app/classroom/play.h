/* A lesson that is being given: which step is shown, what the class guessed, which hints were asked for, and what the
 * goal says. `clearance lesson check` plays a lesson through these functions.
 *
 * Nothing is timed. Names are never stored: guesses are counts of raised hands. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "lesson/lesson.h"

typedef enum PlayGoal { PLAY_GOAL_OPEN, PLAY_GOAL_NO, PLAY_GOAL_YES } PlayGoal;

enum {
    PLAY_VOTES = 2, /* the class votes once more after talking */
    PLAY_HANDS_MOST = 999,
    PLAY_NUMBERS_MOST = 60, /* guesses that are numbers, of each vote */
    PLAY_TYPED_MOST = 10,   /* characters of one */
};

/* What was done in a step. */
typedef struct PlayStep {
    int hands[PLAY_VOTES][LESSON_OPTIONS_MOST];
    double numbers[PLAY_VOTES][PLAY_NUMBERS_MOST]; /* (number_count) guesses that are numbers */
    int number_count[PLAY_VOTES];
    char typed[PLAY_TYPED_MOST + 1]; /* the next one so far */
    int vote;                        /* 0, or 1: the second one */
    int chosen;                      /* option answered after watching, from 1; 0: none */
    int hints;                       /* shown, 0 to LESSON_HINTS */
    bool model;                      /* the model answer is shown */
    PlayGoal goal;
} PlayStep;

typedef struct Play {
    Lesson lesson;
    size_t step; /* from 0 */
    PlayStep steps[LESSON_STEPS_MOST];
    bool numbered; /* the numbers of the texts are known */
} Play;

typedef enum PlayKey {
    PLAY_NEXT,  /* PageDown, as presenters' remotes send it: first shows a model answer, then goes on */
    PLAY_BACK,  /* PageUp */
    PLAY_HINT,  /* ? */
    PLAY_VOTE,  /* the class votes again, from nothing */
    PLAY_UNDO,  /* Backspace: takes the last option's hand back, or the last character or number */
    PLAY_DIGIT, /* 1 to 9: counts a hand for an option, or answers; 0: as PLAY_VOTE; 0 to 9 of a guess that is a number
                 */
    PLAY_POINT, /* of such a guess */
    PLAY_ADD,   /* Return: adds the typed guess */
} PlayKey;

/* Returns the step that is shown. */
const LessonStep *play_step(const Play *play);

/* Returns what the window shows in it, with what it takes from the lesson. */
LessonLook play_look(const Play *play);

/* True if nothing of the result may be seen yet: nobody has watched. */
bool play_hides(const Play *play);

/* True if a result may be seen, but not be said: the class says first what it has seen. */
bool play_asks(const Play *play);

/* True if the step can be started again: something of it plays, or is changed. */
bool play_restarts(const Play *play);

/* True if the lesson has begun: hands were counted, or it is past its first step. */
bool play_is_begun(const Play *play);

/* Returns what stands in the place of an answer that is not said yet: "What do you see?". */
const char *play_question(const Play *play);

/* Returns why a key has no use in this step; NULL: it has. */
const char *play_reason(const Play *play, PlayKey key);

/* True if the key belongs to the lesson in this step; otherwise it is the window's. */
bool play_takes(const Play *play, PlayKey key);

/* Carries out a key; `digit` of PLAY_DIGIT. False: the step has no use for it. */
bool play_key(Play *play, PlayKey key, int digit);

/* Returns the names of all keys, of which some have two: "PageDown", "?", "3", "Keypad 3". */
const char *const *play_key_names(size_t *count);

/* Reads such a name; `digit` of an option. False: it is none. */
bool play_read_key(const char *name, PlayKey *key, int *digit);

/* Sets the goal of the step by the verdicts of its conditions. */
void play_judge(Play *play);

/* Returns the hands, or numbers, of a vote. */
int play_hands(const PlayStep *step, int vote);

/* Returns the step with the guesses that a step of kind "compare" or "observe" looks back to; SIZE_MAX: none. */
size_t play_guessed(const Play *play);

/* Returns the last vote of the class in that step: the option with most hands, the one that was chosen last among equal
 * ones; of numbers the middle one, the lower of two. NAN: nobody has guessed yet. */
double play_answer(const Play *play);

/* Returns what scripts expect of: {"step": 2, "steps": 6, "kind": "predict", "goal": "no", "hints": 1, "hands": [9, 14,
 * 5], "vote": 1, "chosen": 0, "hides": true}; new, json_decref it. */
json_t *play_state(const Play *play);
