/* A house under the hand: its plan as it stands, and what was done to it, to be undone and done again.
 *
 * What is edited is the house file's own JSON, one value an element of its lists; a value, once in the draft, never
 * changes. An edit puts other elements in the place of some, and a step remembers both, so that undoing gives the same
 * bytes again. The plan is a reading of the whole: what no file may say, no edit can leave behind.
 *
 *     draft_begin(draft, "Move wardrobe (f3)");            a step, with its name for menus
 *     draft_set_point(draft, "f3", "centre", vec2(1, 2));  any number of changes
 *     draft_try(draft, &fault);                            while a hand moves: does it stand? then it is the plan
 *     draft_rewind(draft);                                 as at the beginning of the step, for the next try
 *     draft_end(draft, &fault);                            it stands, and is a step; or nothing has happened
 *
 * Its file is in draft_file.h, numbers by their names in draft_parameter.h, pieces on a clipboard in draft_clip.h. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "plan/plan.h"

typedef struct Draft Draft;

enum { DRAFT_STEPS_MOST = 10000 /* of those that can be undone; the oldest are forgotten */ };

/* The lists of a house, in the order of its file. */
typedef enum DraftList {
    DRAFT_WALLS,
    DRAFT_DOORS,
    DRAFT_FURNITURE,
    DRAFT_ROOMS,
    DRAFT_EXITS,
    DRAFT_PEOPLE,
    DRAFT_CROWDS,
    DRAFT_ROUTES,
    DRAFT_LISTS,
} DraftList;

/* A house without anything in it, called `name`. draft_destroy releases it. */
Draft *draft_create(const char *name);

/* A draft of `plan`, which it takes; nothing of it is saved. */
Draft *draft_of_plan(Plan *plan);

void draft_destroy(Draft *draft);

/* The last plan that stood; good until a step is begun, tried, ended, cancelled, undone or done again. */
const Plan *draft_plan(const Draft *draft);

/* That plan as plan_write writes it; owned by the draft, good as long as the plan. */
const char *draft_text(const Draft *draft);

/* Another number: another plan. Undone, it is the number that it was. */
uint64_t draft_revision(const Draft *draft);

/* Steps ----------------------------------------------------------------------------------------------------------- */

/* Begins a step; one that was begun is cancelled first. `name` as in "Undo: NAME". */
void draft_begin(Draft *draft, const char *name);
bool draft_is_open(const Draft *draft); /* has one begun? */

/* Does what the elements say now stand as a house? Then it is the plan. False: faults say why not, and the plan is what
 * it was. */
bool draft_try(Draft *draft, Fault *fault);

/* The elements, not the plan, are as at the beginning of the step. */
void draft_rewind(Draft *draft);

/* Ends the step. False: the elements do not stand, and elements and plan are as before it. A step that has changed
 * nothing is none. What could be redone is forgotten. */
bool draft_end(Draft *draft, Fault *fault);
void draft_cancel(Draft *draft);

/* False: there is nothing to undo (redo). An open step is cancelled first. */
bool draft_undo(Draft *draft);
bool draft_redo(Draft *draft);

/* Their names, NULL: there is none. */
const char *draft_undo_name(const Draft *draft);
const char *draft_redo_name(const Draft *draft);

/* How many steps can be undone. */
size_t draft_step_count(const Draft *draft);

/* Elements, in an open step ---------------------------------------------------------------------------------------- */

/* Where an id is: its list, DRAFT_LISTS where there is none, and its place there. */
DraftList draft_find(const Draft *draft, const char *id, size_t *index);

size_t draft_count(const Draft *draft, DraftList list);

/* The element's value, borrowed. NULL: there is no such id. */
json_t *draft_element(const Draft *draft, const char *id);
json_t *draft_at(const Draft *draft, DraftList list, size_t index);

/* Adds an element at the end of its list (steals it), with a new id unless it has one that is free. Its id, good as
 * long as the element. */
const char *draft_add(Draft *draft, DraftList list, json_t *element);

/* Takes an element out, and what cannot be without it: the doors of a wall, a person's name in routes, a route's exit
 * (then the quickest) and a route without people. False: there is none. */
bool draft_remove(Draft *draft, const char *id);

/* Sets a member of an element (steals the value; NULL takes the member out). False: there is no such id. */
bool draft_set(Draft *draft, const char *id, const char *member, json_t *value);
bool draft_set_number(Draft *draft, const char *id, const char *member, double value);
bool draft_set_text(Draft *draft, const char *id, const char *member, const char *value);
bool draft_set_point(Draft *draft, const char *id, const char *member, Vec2 value);
bool draft_set_points(Draft *draft, const char *id, const char *member, const Vec2 *points, size_t count);

/* A member of the house itself, "name", "note", "background" (steals the value; NULL takes it out). */
void draft_set_house(Draft *draft, const char *member, json_t *value);
json_t *draft_house(const Draft *draft, const char *member); /* borrowed, NULL: absent */

/* Renames an element everywhere. False: there is no such id, or the new one is taken or none. */
bool draft_rename(Draft *draft, const char *id, const char *to, Fault *fault);
