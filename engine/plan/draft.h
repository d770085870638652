/* A house that is being edited: its plan, and the steps that can be undone and redone.
 *
 * A draft edits the house file's own JSON, one value per element of its lists; a value in the draft never changes. An
 * edit replaces elements, and a step stores both versions, so that undoing restores the same bytes. The plan is always
 * read from the whole, so no edit can leave a plan that is invalid as a file.
 *
 *     draft_begin(draft, "Move wardrobe (f3)");            a step with its name for menus
 *     draft_set_point(draft, "f3", "centre", vec2(1, 2));  any number of changes
 *     draft_try(draft, &fault);                            during a drag: if valid, it is the plan
 *     draft_rewind(draft);                                 back to the beginning of the step
 *     draft_end(draft, &fault);                            the step is complete, or reverted if invalid
 *
 * Its file is in draft_file.h, numbers by their names in draft_parameter.h, pieces on a clipboard in draft_clip.h. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "plan/plan.h"

typedef struct Draft Draft;

enum { DRAFT_STEPS_MOST = 10000 /* steps that can be undone; the oldest are dropped */ };

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

/* Creates an empty house called `name`. draft_destroy releases it. */
Draft *draft_create(const char *name);

/* Creates a draft of `plan` and takes ownership of it; the draft is not saved. */
Draft *draft_of_plan(Plan *plan);

void draft_destroy(Draft *draft);

/* Returns the last valid plan; it stays until a step is begun, tried, ended, cancelled, undone or redone. */
const Plan *draft_plan(const Draft *draft);

/* Returns that plan in the form of plan_write; owned by the draft and valid as long as the plan. */
const char *draft_text(Draft *draft);

/* Returns a number that identifies the plan. Undoing restores the former number. */
uint64_t draft_revision(const Draft *draft);

/* Steps ----------------------------------------------------------------------------------------------------------- */

/* Begins a step and cancels an open one. `name` as in "Undo: NAME". */
void draft_begin(Draft *draft, const char *name);
bool draft_is_open(const Draft *draft); /* True if a step is open */

/* Reads the elements as a house. If it is valid, it becomes the plan. Otherwise returns false with an error, and the
 * plan is unchanged. */
bool draft_try(Draft *draft, Fault *fault);

/* Restores the elements, but not the plan, of the beginning of the step. */
void draft_rewind(Draft *draft);

/* Ends the step and drops the steps that could be redone. Returns false if the elements are invalid; elements and plan
 * are then as before the step. A step without a change is dropped. */
bool draft_end(Draft *draft, Fault *fault);
void draft_cancel(Draft *draft);

/* Undo or redo a step, after cancelling an open one. Return false if there is none. */
bool draft_undo(Draft *draft);
bool draft_redo(Draft *draft);

/* Return the names of these steps; NULL: none. */
const char *draft_undo_name(const Draft *draft);
const char *draft_redo_name(const Draft *draft);

/* Return the number of steps that can be undone, and of all remembered ones, of which the later ones are undone. */
size_t draft_step_count(const Draft *draft);
size_t draft_step_total(const Draft *draft);

/* Return the name of a remembered step, from the oldest, and the plan's revision after it. */
const char *draft_step_name(const Draft *draft, size_t index);
uint64_t draft_step_revision(const Draft *draft, size_t index);

/* Elements, in an open step ---------------------------------------------------------------------------------------- */

/* Finds an id: returns its list, DRAFT_LISTS if there is none, and its index. */
DraftList draft_find(const Draft *draft, const char *id, size_t *index);

size_t draft_count(const Draft *draft, DraftList list);

/* Return the value of an element, borrowed. NULL: unknown id. */
json_t *draft_element(const Draft *draft, const char *id);
json_t *draft_at(const Draft *draft, DraftList list, size_t index);

/* Appends an element to its list (steals it), with a new id unless it has a free one. Returns its id, valid as long as
 * the element. */
const char *draft_add(Draft *draft, DraftList list, json_t *element);

/* Removes an element with everything that depends on it: the doors of a wall, a person's name in routes, a route's exit
 * (then the quickest) and a route without people. Returns false if there is none. */
bool draft_remove(Draft *draft, const char *id);

/* Sets a member of an element (steals the value; NULL removes the member). Returns false for an unknown id. */
bool draft_set(Draft *draft, const char *id, const char *member, json_t *value);
bool draft_set_number(Draft *draft, const char *id, const char *member, double value);
bool draft_set_text(Draft *draft, const char *id, const char *member, const char *value);
bool draft_set_point(Draft *draft, const char *id, const char *member, Vec2 value);
bool draft_set_points(Draft *draft, const char *id, const char *member, const Vec2 *points, size_t count);

/* Sets a member of the house itself, "name", "note", "background" (steals the value; NULL removes it). */
void draft_set_house(Draft *draft, const char *member, json_t *value);
json_t *draft_house(const Draft *draft, const char *member); /* borrowed, NULL: absent */

/* Renames an element and all references to it. Returns false if there is no such id, or the new id is used or invalid.
 */
bool draft_rename(Draft *draft, const char *id, const char *to, Fault *fault);
