/* What a draft consists of: for the files draft*.c. */
#pragma once

#include "plan/draft.h"

/* One value in the place of another one. */
typedef struct DraftChange {
    DraftList list; /* DRAFT_LISTS: a member of the house itself */
    size_t index;
    char *member;           /* of the house; NULL in a list */
    json_t *before, *after; /* NULL: there was, or is, none */
} DraftChange;

typedef struct DraftStep {
    char *name;
    DraftChange *changes; /* (count) in the order in which they were made */
    size_t count, capacity;
    uint64_t revision; /* of the plan after it */
} DraftStep;

struct Draft {
    json_t *lists[DRAFT_LISTS]; /* arrays */
    json_t *head;               /* an object of all other members */
    Plan plan;
    char *text; /* NULL: nobody has asked for it since */
    uint64_t revision, newest;
    uint64_t first; /* before any step that is remembered */

    DraftStep *steps; /* (step_count) of which the first `done` are done */
    size_t step_count, step_capacity, done;
    DraftStep open;
    bool is_open;
    char *begun; /* the plan's text when it was opened */

    char *path;  /* of the file; NULL: none */
    char *saved; /* text of the plan in it; NULL: nothing is */
    char *bytes; /* (byte_count) of the file, where they are another way to write that; or NULL */
    size_t byte_count;
    char id[32]; /* that was free when the last element was added */
};

/* A draft of a plan that a text says, of which nothing is saved; it takes the plan. */
Draft *draft_of_plan(Plan *plan);

/* Makes a change in the open step, which takes `after`: an element of a list, in the place of `before`, or a member of
 * the house itself (DRAFT_LISTS). */
void draft_change_make(Draft *draft, DraftList list, size_t index, const char *member, json_t *before, json_t *after);

/* Puts another value in the place of an element, which it takes; NULL: the element is taken out. */
void draft_change_element(Draft *draft, DraftList list, size_t index, json_t *after);

/* A step as it was made, once more, and back. */
void draft_change_redo(Draft *draft, const DraftStep *step);
void draft_change_undo(Draft *draft, const DraftStep *step);

/* The step is one without changes; then it is none. */
void draft_change_forget(DraftStep *step);
void draft_change_clear(DraftStep *step);
