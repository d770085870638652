#include "plan/draft.h"

#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"
#include "plan/draft_change.h"
#include "plan/plan_json.h"
#include "plan/plan_tables.h"

_Static_assert((int)DRAFT_WALLS == (int)LIST_WALLS && (int)DRAFT_ROUTES == (int)LIST_ROUTES &&
                   (int)DRAFT_LISTS == (int)PLAN_LISTS,
               "the lists of a plan, in their order");

/* The plan -------------------------------------------------------------------------------------------------------- */

/* Returns the whole as one value whose lists are borrowed. */
static json_t *whole(const Draft *draft) {
    json_t *house = json_copy(draft->head);
    for (int l = 0; l < DRAFT_LISTS; l++)
        json_object_set(house, plan_tables_lists[l].key, draft->lists[l]);
    return house;
}

bool draft_try(Draft *draft, Fault *fault) {
    json_t *house = whole(draft);
    bool good = plan_read_values(&draft->plan, draft->path ? draft->path : "", house, fault);
    json_decref(house);
    if (!good)
        return false;
    memory_free(draft->text);
    draft->text = NULL;
    draft->revision = ++draft->newest;
    return true;
}

/* Restores a former revision; the plan is read again only if another revision was current. */
static void stand_again(Draft *draft, uint64_t revision) {
    if (draft->revision == revision)
        return;
    Fault none = {0};
    draft_try(draft, &none);
    draft->revision = revision;
    fault_clear(&none);
}

/* Returns the revision after the last step in effect. */
static uint64_t revision_done(const Draft *draft) {
    return draft->done ? draft->steps[draft->done - 1].revision : draft->first;
}

/* Copies a house's values into the draft. */
static void take_values(Draft *draft, json_t *house) {
    draft->head = json_copy(house);
    for (int l = 0; l < DRAFT_LISTS; l++) {
        const char *key = plan_tables_lists[l].key;
        json_t *list = json_object_get(house, key);
        draft->lists[l] = json_is_array(list) ? json_copy(list) : json_array();
        json_object_del(draft->head, key);
    }
}

Draft *draft_of_plan(Plan *plan) {
    Draft *draft = memory_zeroed(1, sizeof *draft);
    draft->plan = *plan;
    json_t *house = json_loads(draft_text(draft), 0, NULL);
    take_values(draft, house);
    json_decref(house);
    return draft;
}

Draft *draft_create(const char *name) {
    Plan plan = {0};
    Fault none = {0};
    json_t *house =
        json_pack("{s:s, s:i, s:s, s:[]}", "format", "clearance-house", "version", 1, "name", name, "walls");
    plan_read_values(&plan, "", house, &none);
    json_decref(house);
    fault_clear(&none);
    return draft_of_plan(&plan);
}

static void forget_undone(Draft *draft) {
    while (draft->step_count > draft->done)
        draft_change_clear(&draft->steps[--draft->step_count]);
}

void draft_destroy(Draft *draft) {
    if (!draft)
        return;
    draft->done = 0;
    forget_undone(draft);
    memory_free(draft->steps);
    draft_change_clear(&draft->open);
    for (int l = 0; l < DRAFT_LISTS; l++)
        json_decref(draft->lists[l]);
    json_decref(draft->head);
    plan_free(&draft->plan);
    memory_free(draft->text);
    memory_free(draft->path);
    memory_free(draft->saved);
    memory_free(draft->bytes);
    memory_free(draft->begun);
    memory_free(draft);
}

const Plan *draft_plan(const Draft *draft) {
    return &draft->plan;
}

const char *draft_text(Draft *draft) {
    if (!draft->text)
        draft->text = plan_text(&draft->plan); /* made on demand */
    return draft->text;
}

uint64_t draft_revision(const Draft *draft) {
    return draft->revision;
}

/* Steps ----------------------------------------------------------------------------------------------------------- */

void draft_begin(Draft *draft, const char *name) {
    draft_cancel(draft);
    draft->open.name = text_copy(name);
    draft->is_open = true;
    memory_free(draft->begun);
    draft->begun = text_copy(draft_text(draft));
}

bool draft_is_open(const Draft *draft) {
    return draft->is_open;
}

void draft_rewind(Draft *draft) {
    draft_change_undo(draft, &draft->open);
    draft_change_forget(&draft->open);
}

void draft_cancel(Draft *draft) {
    if (!draft->is_open)
        return;
    draft_rewind(draft);
    draft_change_clear(&draft->open);
    draft->is_open = false;
    stand_again(draft, revision_done(draft));
}

/* Drops the oldest step if there are too many. */
static void make_room(Draft *draft) {
    if (draft->step_count < DRAFT_STEPS_MOST)
        return;
    draft->first = draft->steps[0].revision;
    draft_change_clear(&draft->steps[0]);
    draft->step_count--;
    draft->done--;
    memmove(draft->steps, draft->steps + 1, draft->step_count * sizeof *draft->steps);
}

bool draft_end(Draft *draft, Fault *fault) {
    if (!draft->is_open)
        return true;
    if (!draft_try(draft, fault)) {
        draft_cancel(draft);
        return false;
    }
    if (strcmp(draft_text(draft), draft->begun) == 0) {
        draft_cancel(draft);
        return true;
    }
    forget_undone(draft);
    make_room(draft);
    draft->steps = memory_reserve(draft->steps, &draft->step_capacity, draft->step_count + 1, sizeof *draft->steps);
    draft->open.revision = draft->revision;
    draft->steps[draft->step_count++] = draft->open;
    draft->done++;
    draft->open = (DraftStep){0};
    draft->is_open = false;
    return true;
}

bool draft_undo(Draft *draft) {
    draft_cancel(draft);
    if (!draft->done)
        return false;
    const DraftStep *step = &draft->steps[--draft->done];
    draft_change_undo(draft, step);
    stand_again(draft, revision_done(draft));
    return true;
}

bool draft_redo(Draft *draft) {
    draft_cancel(draft);
    if (draft->done == draft->step_count)
        return false;
    const DraftStep *step = &draft->steps[draft->done++];
    draft_change_redo(draft, step);
    stand_again(draft, step->revision);
    return true;
}

const char *draft_undo_name(const Draft *draft) {
    return draft->done ? draft->steps[draft->done - 1].name : NULL;
}

const char *draft_redo_name(const Draft *draft) {
    return draft->done < draft->step_count ? draft->steps[draft->done].name : NULL;
}

size_t draft_step_count(const Draft *draft) {
    return draft->done;
}

size_t draft_step_total(const Draft *draft) {
    return draft->step_count;
}

const char *draft_step_name(const Draft *draft, size_t index) {
    return draft->steps[index].name;
}

uint64_t draft_step_revision(const Draft *draft, size_t index) {
    return draft->steps[index].revision;
}

/* Elements -------------------------------------------------------------------------------------------------------- */

DraftList draft_find(const Draft *draft, const char *id, size_t *index) {
    for (int l = 0; *id && l < DRAFT_LISTS; l++)
        for (size_t i = 0; i < json_array_size(draft->lists[l]); i++)
            if (strcmp(plan_json_text(json_array_get(draft->lists[l], i), "id"), id) == 0) {
                *index = i;
                return (DraftList)l;
            }
    return DRAFT_LISTS;
}

size_t draft_count(const Draft *draft, DraftList list) {
    return json_array_size(draft->lists[list]);
}

json_t *draft_at(const Draft *draft, DraftList list, size_t index) {
    return json_array_get(draft->lists[list], index);
}

json_t *draft_element(const Draft *draft, const char *id) {
    size_t index;
    DraftList list = draft_find(draft, id, &index);
    return list < DRAFT_LISTS ? draft_at(draft, list, index) : NULL;
}

/* Returns an unused id: the list's letter and a number. It is valid until the next call. */
static const char *free_id(Draft *draft, DraftList list) {
    static const char *const letters[DRAFT_LISTS] = {"w", "d", "f", "r", "e", "p", "c", "R"};
    size_t index;
    for (size_t number = draft_count(draft, list) + 1;; number++) {
        snprintf(draft->id, sizeof draft->id, "%s%zu", letters[list], number);
        if (draft_find(draft, draft->id, &index) == DRAFT_LISTS)
            return draft->id;
    }
}

const char *draft_add(Draft *draft, DraftList list, json_t *element) {
    size_t index, count = draft_count(draft, list);
    const char *id = plan_json_text(element, "id");
    if (!*id || draft_find(draft, id, &index) < DRAFT_LISTS) {
        json_t *named = plan_json_with(element, "id", json_string(free_id(draft, list)));
        json_decref(element);
        element = named;
    }
    draft_change_make(draft, list, count, NULL, NULL, element);
    return plan_json_text(element, "id");
}

/* Replaces all references to an element, or removes them if `to` is NULL, together with elements that cannot be without
 * it. */
static void rename_all(Draft *draft, const char *from, const char *to) {
    for (int l = 0; l < DRAFT_LISTS; l++)
        for (size_t i = draft_count(draft, (DraftList)l); i > 0; i--) {
            json_t *element = draft_at(draft, (DraftList)l, i - 1), *renamed = plan_json_renamed(element, from, to);
            bool wall = l == DRAFT_DOORS && !*plan_json_text(renamed, "wall");
            bool alone =
                l == DRAFT_ROUTES && renamed != element && plan_json_is_empty(json_object_get(renamed, "people"));
            if (renamed != element && !wall && !alone) {
                draft_change_element(draft, (DraftList)l, i - 1, renamed);
                continue;
            }
            json_decref(renamed);
            if (renamed != element)
                draft_change_element(draft, (DraftList)l, i - 1, NULL);
        }
}

bool draft_remove(Draft *draft, const char *id) {
    size_t index;
    DraftList list = draft_find(draft, id, &index);
    if (list == DRAFT_LISTS)
        return false;
    char *name = text_copy(id); /* `id` may be the element's own */
    draft_change_element(draft, list, index, NULL);
    rename_all(draft, name, NULL);
    memory_free(name);
    return true;
}

bool draft_set(Draft *draft, const char *id, const char *member, json_t *value) {
    size_t index;
    DraftList list = draft_find(draft, id, &index);
    if (list == DRAFT_LISTS) {
        json_decref(value);
        return false;
    }
    draft_change_element(draft, list, index, plan_json_with(draft_at(draft, list, index), member, value));
    return true;
}

bool draft_set_number(Draft *draft, const char *id, const char *member, double value) {
    return draft_set(draft, id, member, json_number(value));
}

bool draft_set_text(Draft *draft, const char *id, const char *member, const char *value) {
    return draft_set(draft, id, member, json_string(value));
}

bool draft_set_point(Draft *draft, const char *id, const char *member, Vec2 value) {
    return draft_set(draft, id, member, plan_json_point(value));
}

bool draft_set_points(Draft *draft, const char *id, const char *member, const Vec2 *points, size_t count) {
    return draft_set(draft, id, member, plan_json_points(points, count));
}

bool draft_rename(Draft *draft, const char *id, const char *to, Fault *fault) {
    size_t index;
    if (draft_find(draft, id, &index) == DRAFT_LISTS) {
        fault_add(fault, "unknown id \"%.60s\"", id);
        return false;
    }
    if (strcmp(id, to) == 0)
        return true;
    if (!*to || to[strspn(to, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_")]) {
        fault_add(fault, "\"%.60s\" is not a valid id: it must be one or more letters, digits, - or _", to);
        return false;
    }
    if (draft_find(draft, to, &index) < DRAFT_LISTS) {
        fault_add(fault, "the id \"%.60s\" is already used; ids must be unique", to);
        return false;
    }
    char *name = text_copy(id);
    rename_all(draft, name, to);
    memory_free(name);
    return true;
}

/* The house itself ---------------------------------------------------------------------------------- */

json_t *draft_house(const Draft *draft, const char *member) {
    return json_object_get(draft->head, member);
}

void draft_set_house(Draft *draft, const char *member, json_t *value) {
    draft_change_make(draft, DRAFT_LISTS, 0, member, json_object_get(draft->head, member), value);
}
