/* The state of a draft and the changes of its open step, so that the step can be undone and redone. Private to the
 * files draft*.c. */
#pragma once

#include "plan/draft.h"

/* Replacement of one value by another. */
typedef struct DraftChange {
    DraftList list; /* DRAFT_LISTS: a member of the house itself */
    size_t index;
    char *member;           /* name of the member of the house; NULL in a list */
    json_t *before, *after; /* NULL: absent */
} DraftChange;

typedef struct DraftStep {
    char *name;
    DraftChange *changes; /* (count) in the order of editing */
    size_t count, capacity;
    uint64_t revision; /* of the plan after the step */
} DraftStep;

struct Draft {
    json_t *lists[DRAFT_LISTS]; /* arrays */
    json_t *head;               /* object of all other members */
    Plan plan;
    char *text; /* text of the plan; NULL: not made since the last change */
    uint64_t revision, newest;
    uint64_t first; /* revision before the oldest remembered step */

    DraftStep *steps; /* (step_count); the first `done` are in effect */
    size_t step_count, step_capacity, done;
    DraftStep open;
    bool is_open;
    char *begun; /* text of the plan when the open step began */

    char *path;  /* path of the file; NULL: none */
    char *saved; /* text of the plan in the file; NULL: not saved */
    char *bytes; /* (byte_count) of the file if they differ from `saved`; or NULL */
    size_t byte_count;
    char id[32]; /* the id that free_id returned last */
};

/* Makes a change in the open step and takes `after`: replaces an element of a list, `before`, or a member of the house
 * itself (DRAFT_LISTS). */
void draft_change_make(Draft *draft, DraftList list, size_t index, const char *member, json_t *before, json_t *after);

/* Replaces an element and takes `after`; NULL removes the element. */
void draft_change_element(Draft *draft, DraftList list, size_t index, json_t *after);

/* Applies all changes of a step again, or reverts them. */
void draft_change_redo(Draft *draft, const DraftStep *step);
void draft_change_undo(Draft *draft, const DraftStep *step);

/* Releases the changes of a step; draft_change_clear releases its name, too. */
void draft_change_forget(DraftStep *step);
void draft_change_clear(DraftStep *step);
