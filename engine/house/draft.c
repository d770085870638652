#include "house/draft.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"
#include "house/pieces.h"
#include "house/plan_tables.h"

_Static_assert((int)DRAFT_WALLS == (int)LIST_WALLS && (int)DRAFT_ROUTES == (int)LIST_ROUTES &&
                   (int)DRAFT_LISTS == (int)PLAN_LISTS,
               "the lists of a plan, in their order");

/* One value in the place of another one. */
typedef struct Change {
    DraftList list; /* DRAFT_LISTS: a member of the house itself */
    size_t index;
    char *member;           /* of the house; NULL in a list */
    json_t *before, *after; /* NULL: there was, or is, none */
} Change;

typedef struct Step {
    char *name;
    Change *changes; /* (count) in the order in which they were made */
    size_t count, capacity;
    uint64_t revision; /* of the plan after it */
} Step;

struct Draft {
    json_t *lists[DRAFT_LISTS]; /* arrays */
    json_t *head;               /* an object of all other members */
    Plan plan;
    char *text; /* NULL: nobody has asked for it since */
    uint64_t revision, newest;
    uint64_t first; /* before any step that is remembered */

    Step *steps; /* (step_count) of which the first `done` are done */
    size_t step_count, step_capacity, done;
    Step open;
    bool is_open;
    char *begun; /* the plan's text when it was opened */

    char *path;  /* of the file; NULL: none */
    char *saved; /* text of the plan in it; NULL: nothing is */
    char *bytes; /* (byte_count) of the file, where they are another way to write that; or NULL */
    size_t byte_count;
    char id[32]; /* of draft_free_id */
};

/* Values ---------------------------------------------------------------------------------------------------------- */

static void put(Draft *draft, const Change *change, json_t *before, json_t *after) {
    json_t *list = change->list < DRAFT_LISTS ? draft->lists[change->list] : NULL;
    if (!list && after)
        json_object_set(draft->head, change->member, after);
    else if (!list)
        json_object_del(draft->head, change->member);
    else if (before && after)
        json_array_set(list, change->index, after);
    else if (after)
        json_array_insert(list, change->index, after);
    else
        json_array_remove(list, change->index);
}

static void apply(Draft *draft, const Change *change) {
    put(draft, change, change->before, change->after);
}

static void take_back(Draft *draft, const Change *change) {
    put(draft, change, change->after, change->before);
}

static char *copy_text(const char *text) {
    char *copy = memory_allocate(strlen(text) + 1, 1);
    return strcpy(copy, text);
}

/* Makes a change in the open step; steals `after`. */
static void change(Draft *draft, DraftList list, size_t index, const char *member, json_t *before, json_t *after) {
    Step *step = &draft->open;
    step->changes = memory_reserve(step->changes, &step->capacity, step->count + 1, sizeof *step->changes);
    Change *made = &step->changes[step->count++];
    *made = (Change){list, index, member ? copy_text(member) : NULL, json_incref(before), after};
    apply(draft, made);
}

static void change_clear(Change *made) {
    json_decref(made->before);
    json_decref(made->after);
    memory_free(made->member);
}

static void step_clear(Step *step) {
    for (size_t i = 0; i < step->count; i++)
        change_clear(&step->changes[i]);
    memory_free(step->changes);
    memory_free(step->name);
    *step = (Step){0};
}

/* The plan -------------------------------------------------------------------------------------------------------- */

/* The whole as one value, of which the lists are borrowed. */
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

/* What has stood before stands again; the plan is as good where nothing else has stood since. */
static void stand_again(Draft *draft, uint64_t revision) {
    if (draft->revision == revision)
        return;
    Fault none = {0};
    draft_try(draft, &none);
    draft->revision = revision;
    fault_clear(&none);
}

/* The revision of what is done. */
static uint64_t revision_done(const Draft *draft) {
    return draft->done ? draft->steps[draft->done - 1].revision : draft->first;
}

/* Takes over a house's values. */
static void take_values(Draft *draft, json_t *house) {
    draft->head = json_copy(house);
    for (int l = 0; l < DRAFT_LISTS; l++) {
        const char *key = plan_tables_lists[l].key;
        json_t *list = json_object_get(house, key);
        draft->lists[l] = json_is_array(list) ? json_copy(list) : json_array();
        json_object_del(draft->head, key);
    }
}

/* A draft of a plan's text, which is good; it takes the plan. */
static Draft *draft_of(Plan *plan) {
    Draft *draft = memory_allocate(1, sizeof *draft);
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
    return draft_of(&plan);
}

static void keep_file(Draft *draft, const char *path, char *bytes, size_t byte_count) {
    char *kept = copy_text(path); /* which may be the draft's own */
    memory_free(draft->path);
    memory_free(draft->saved);
    memory_free(draft->bytes);
    draft->path = kept;
    draft->saved = copy_text(draft_text(draft));
    draft->bytes = bytes;
    draft->byte_count = byte_count;
}

Draft *draft_read(const char *path, const char *const *settings, size_t setting_count, Fault *fault) {
    Plan plan = {0};
    size_t byte_count = 0;
    char *bytes = text_read_file(path, JSON_LARGEST_FILE, &byte_count);
    if (!bytes) {
        fault_add(fault, "%s:1:1: cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    if (!plan_read_text(&plan, path, bytes, settings, setting_count, fault)) {
        memory_free(bytes);
        return NULL;
    }
    Draft *draft = draft_of(&plan);
    if (setting_count) { /* the file's bytes are not what it is */
        memory_free(bytes);
        bytes = NULL;
    }
    keep_file(draft, path, bytes, byte_count);
    return draft;
}

Draft *draft_read_text(const char *path, const char *text, Fault *fault) {
    Plan plan = {0};
    if (!plan_read_text(&plan, path, text, NULL, 0, fault))
        return NULL;
    return draft_of(&plan);
}

static void forget_undone(Draft *draft) {
    while (draft->step_count > draft->done)
        step_clear(&draft->steps[--draft->step_count]);
}

void draft_destroy(Draft *draft) {
    if (!draft)
        return;
    draft->done = 0;
    forget_undone(draft);
    memory_free(draft->steps);
    step_clear(&draft->open);
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

const char *draft_text(const Draft *draft) {
    if (!draft->text)
        ((Draft *)draft)->text = plan_text(&draft->plan); /* only now somebody wants it */
    return draft->text;
}

uint64_t draft_revision(const Draft *draft) {
    return draft->revision;
}

/* Steps ----------------------------------------------------------------------------------------------------------- */

void draft_begin(Draft *draft, const char *name) {
    draft_cancel(draft);
    draft->open.name = copy_text(name);
    draft->is_open = true;
    memory_free(draft->begun);
    draft->begun = copy_text(draft_text(draft));
}

bool draft_is_open(const Draft *draft) {
    return draft->is_open;
}

void draft_rewind(Draft *draft) {
    Step *step = &draft->open;
    while (step->count) {
        Change *last = &step->changes[--step->count];
        take_back(draft, last);
        change_clear(last);
    }
}

void draft_cancel(Draft *draft) {
    if (!draft->is_open)
        return;
    draft_rewind(draft);
    step_clear(&draft->open);
    draft->is_open = false;
    stand_again(draft, revision_done(draft));
}

/* The oldest steps are forgotten. */
static void make_room(Draft *draft) {
    if (draft->step_count < DRAFT_STEPS_MOST)
        return;
    draft->first = draft->steps[0].revision;
    step_clear(&draft->steps[0]);
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
    draft->open = (Step){0};
    draft->is_open = false;
    return true;
}

bool draft_undo(Draft *draft) {
    draft_cancel(draft);
    if (!draft->done)
        return false;
    const Step *step = &draft->steps[--draft->done];
    for (size_t i = step->count; i > 0; i--)
        take_back(draft, &step->changes[i - 1]);
    stand_again(draft, revision_done(draft));
    return true;
}

bool draft_redo(Draft *draft) {
    draft_cancel(draft);
    if (draft->done == draft->step_count)
        return false;
    const Step *step = &draft->steps[draft->done++];
    for (size_t i = 0; i < step->count; i++)
        apply(draft, &step->changes[i]);
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

/* Elements -------------------------------------------------------------------------------------------------------- */

DraftList draft_find(const Draft *draft, const char *id, size_t *index) {
    for (int l = 0; *id && l < DRAFT_LISTS; l++)
        for (size_t i = 0; i < json_array_size(draft->lists[l]); i++)
            if (strcmp(pieces_text(json_array_get(draft->lists[l], i), "id"), id) == 0) {
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

const char *draft_free_id(Draft *draft, DraftList list) {
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
    const char *id = pieces_text(element, "id");
    if (!*id || draft_find(draft, id, &index) < DRAFT_LISTS) {
        json_t *named = pieces_with(element, "id", json_string(draft_free_id(draft, list)));
        json_decref(element);
        element = named;
    }
    change(draft, list, count, NULL, NULL, element);
    return pieces_text(element, "id");
}

/* Puts another value in the place of one; steals it. */
static void replace(Draft *draft, DraftList list, size_t index, json_t *after) {
    change(draft, list, index, NULL, draft_at(draft, list, index), after);
}

static void take_out(Draft *draft, DraftList list, size_t index) {
    change(draft, list, index, NULL, draft_at(draft, list, index), NULL);
}

/* Whatever names an element names another one, or none; NULL `to`: what cannot be without it goes, too. */
static void rename_all(Draft *draft, const char *from, const char *to) {
    for (int l = 0; l < DRAFT_LISTS; l++)
        for (size_t i = draft_count(draft, (DraftList)l); i > 0; i--) {
            json_t *element = draft_at(draft, (DraftList)l, i - 1), *renamed = pieces_renamed(element, from, to);
            bool wall = l == DRAFT_DOORS && !*pieces_text(renamed, "wall");
            bool alone = l == DRAFT_ROUTES && renamed != element && pieces_is_empty(json_object_get(renamed, "people"));
            if (renamed != element && !wall && !alone) {
                replace(draft, (DraftList)l, i - 1, renamed);
                continue;
            }
            json_decref(renamed);
            if (renamed != element)
                take_out(draft, (DraftList)l, i - 1);
        }
}

bool draft_remove(Draft *draft, const char *id) {
    size_t index;
    DraftList list = draft_find(draft, id, &index);
    if (list == DRAFT_LISTS)
        return false;
    char *name = copy_text(id); /* which may be the element's own */
    take_out(draft, list, index);
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
    replace(draft, list, index, pieces_with(draft_at(draft, list, index), member, value));
    return true;
}

bool draft_set_number(Draft *draft, const char *id, const char *member, double value) {
    return draft_set(draft, id, member, json_number(value));
}

bool draft_set_text(Draft *draft, const char *id, const char *member, const char *value) {
    return draft_set(draft, id, member, json_string(value));
}

bool draft_set_point(Draft *draft, const char *id, const char *member, Vec2 value) {
    return draft_set(draft, id, member, pieces_point(value));
}

bool draft_set_points(Draft *draft, const char *id, const char *member, const Vec2 *points, size_t count) {
    return draft_set(draft, id, member, pieces_points(points, count));
}

void draft_move(Draft *draft, const char *id, Vec2 by) {
    size_t index;
    DraftList list = draft_find(draft, id, &index);
    if (list < DRAFT_LISTS)
        replace(draft, list, index, pieces_moved(draft_at(draft, list, index), by));
}

bool draft_rename(Draft *draft, const char *id, const char *to, Fault *fault) {
    size_t index;
    if (draft_find(draft, id, &index) == DRAFT_LISTS) {
        fault_add(fault, "there is nothing called \"%.60s\"", id);
        return false;
    }
    if (strcmp(id, to) == 0)
        return true;
    if (!*to || to[strspn(to, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_")]) {
        fault_add(fault, "\"%.60s\" cannot be an id, must be one or more letters, digits, - or _", to);
        return false;
    }
    if (draft_find(draft, to, &index) < DRAFT_LISTS) {
        fault_add(fault, "there is something called \"%.60s\" already, ids must differ", to);
        return false;
    }
    char *name = copy_text(id);
    rename_all(draft, name, to);
    memory_free(name);
    return true;
}

/* The house itself and parameters ---------------------------------------------------------------------------------- */

json_t *draft_house(const Draft *draft, const char *member) {
    return json_object_get(draft->head, member);
}

void draft_set_house(Draft *draft, const char *member, json_t *value) {
    change(draft, DRAFT_LISTS, 0, member, json_object_get(draft->head, member), value);
}

/* Sets a member of an object that is a member of the house: "run", "overrides". */
static void set_in_house(Draft *draft, const char *object, const char *member, json_t *value) {
    json_t *before = draft_house(draft, object), *empty = json_object();
    draft_set_house(draft, object, pieces_with(json_is_object(before) ? before : empty, member, value));
    json_decref(empty);
}

/* "at.x" of an element: one number of its point; steals the value. False: it has no such point. */
static bool set_component(Draft *draft, const char *id, const char *name, json_t *value) {
    char member[32];
    int used = 0;
    if (sscanf(name, "%31[a-z_].%n", member, &used) != 1 || !used ||
        (strcmp(name + used, "x") != 0 && strcmp(name + used, "y") != 0))
        return false;
    const json_t *point = json_object_get(draft_element(draft, id), member);
    if (json_array_size(point) != 2)
        return false;
    json_t *moved = json_copy((json_t *)point);
    json_array_set_new(moved, name[used] == 'y', value);
    return draft_set(draft, id, member, moved);
}

bool draft_set_parameter(Draft *draft, const char *name, json_t *value, Fault *fault) {
    char kind[32], id[64];
    int used = 0;
    size_t index;
    if (strncmp(name, "run.", 4) == 0 && name[4]) {
        set_in_house(draft, "run", name + 4, value);
        return true;
    }
    if (plan_is_of_profile(name)) {
        set_in_house(draft, "overrides", name, value);
        return true;
    }
    if (sscanf(name, "%31[a-z].%63[A-Za-z0-9_-].%n", kind, id, &used) == 2 && used && name[used]) {
        DraftList list = draft_find(draft, id, &index);
        if (list < DRAFT_LISTS && strcmp(plan_tables_lists[list].table.what, kind) == 0)
            return set_component(draft, id, name + used, value) || draft_set(draft, id, name + used, value);
    }
    fault_add(fault, "there is nothing called \"%.100s\"", name);
    json_decref(value);
    return false;
}

/* Pieces ---------------------------------------------------------------------------------------------------------- */

static bool is_among(const char *id, const char *const *ids, size_t id_count) {
    for (size_t i = 0; i < id_count; i++)
        if (strcmp(ids[i], id) == 0)
            return true;
    return false;
}

char *draft_copy(const Draft *draft, const char *const *ids, size_t id_count) {
    json_t *pieces = json_pack("{s:s, s:i}", "format", "clearance-pieces", "version", 1);
    size_t found = 0;
    for (int l = 0; l < DRAFT_LISTS; l++) {
        json_t *list = json_array();
        for (size_t i = 0; i < draft_count(draft, (DraftList)l); i++) {
            json_t *element = draft_at(draft, (DraftList)l, i);
            if (is_among(pieces_text(element, "id"), ids, id_count) ||
                (l == DRAFT_DOORS && is_among(pieces_text(element, "wall"), ids, id_count)))
                json_array_append(list, element);
        }
        found += json_array_size(list);
        if (json_array_size(list))
            json_object_set(pieces, plan_tables_lists[l].key, list);
        json_decref(list);
    }
    char *text = found ? json_line(pieces) : NULL;
    json_decref(pieces);
    return text;
}

/* Other names for those pieces that have one which is taken: "old" to "new". */
static json_t *new_names(Draft *draft, const json_t *pieces) {
    json_t *names = json_object();
    for (int l = 0; l < DRAFT_LISTS; l++) {
        const json_t *list = json_object_get(pieces, plan_tables_lists[l].key);
        for (size_t i = 0; i < json_array_size(list); i++) {
            /* each has a place in the list at once, so that the next name is another one */
            const char *id = draft_add(draft, (DraftList)l, json_incref(json_array_get(list, i)));
            json_object_set_new(names, pieces_text(json_array_get(list, i), "id"), json_string(id));
        }
    }
    return names;
}

/* An added piece, with the names that the others have now; steals nothing. */
static json_t *renamed_by(json_t *element, json_t *names) {
    static const char *const references[] = {"wall", "exit"};
    json_t *renamed = json_copy(element), *people = json_object_get(element, "people");
    for (size_t i = 0; i < sizeof references / sizeof *references; i++) {
        json_t *name = json_object_get(names, pieces_text(element, references[i]));
        if (name)
            json_object_set(renamed, references[i], name);
    }
    if (!json_is_array(people))
        return renamed;
    json_t *list = json_array();
    for (size_t i = 0; i < json_array_size(people); i++) {
        json_t *id = json_array_get(people, i);
        json_t *name = json_is_string(id) ? json_object_get(names, json_string_value(id)) : NULL;
        json_array_append(list, name ? name : id);
    }
    json_object_set_new(renamed, "people", list);
    return renamed;
}

bool draft_paste(Draft *draft, const char *text, Vec2 by, const char ***ids, size_t *id_count, Fault *fault) {
    json_t *pieces = pieces_read(text, fault);
    if (!pieces)
        return false;
    size_t first[DRAFT_LISTS], capacity = 0;
    for (int l = 0; l < DRAFT_LISTS; l++)
        first[l] = draft_count(draft, (DraftList)l);
    json_t *names = new_names(draft, pieces);
    *ids = NULL;
    *id_count = 0;
    for (int l = 0; l < DRAFT_LISTS; l++)
        for (size_t i = first[l]; i < draft_count(draft, (DraftList)l); i++) {
            json_t *renamed = renamed_by(draft_at(draft, (DraftList)l, i), names);
            json_t *moved = pieces_moved(renamed, by);
            json_decref(renamed);
            replace(draft, (DraftList)l, i, moved);
            *ids = memory_reserve(*ids, &capacity, *id_count + 1, sizeof **ids);
            (*ids)[(*id_count)++] = pieces_text(moved, "id");
        }
    json_decref(names);
    json_decref(pieces);
    return true;
}

/* Files ----------------------------------------------------------------------------------------------------------- */

const char *draft_path(const Draft *draft) {
    return draft->path;
}

bool draft_is_changed(const Draft *draft) {
    return !draft->saved || strcmp(draft->saved, draft_text(draft)) != 0;
}

bool draft_save(Draft *draft, const char *path, Fault *fault) {
    draft_cancel(draft);
    bool as_read = draft->bytes && !draft_is_changed(draft);
    const char *bytes = as_read ? draft->bytes : draft_text(draft);
    size_t count = as_read ? draft->byte_count : strlen(bytes);
    int error = text_write_file(path, bytes, count);
    if (error) {
        fault_add(fault, "%s: cannot be written: %s", path, strerror(error));
        return false;
    }
    char *kept = as_read ? draft->bytes : NULL;
    if (as_read)
        draft->bytes = NULL;
    keep_file(draft, path, kept, count);
    return true;
}

void draft_reset(Draft *draft, const char *name) {
    json_t *house = draft->saved ? json_loads(draft->saved, 0, NULL) : NULL;
    if (!house)
        return;
    draft_begin(draft, name);
    for (int l = 0; l < DRAFT_LISTS; l++) {
        while (draft_count(draft, (DraftList)l))
            take_out(draft, (DraftList)l, draft_count(draft, (DraftList)l) - 1);
        const json_t *list = json_object_get(house, plan_tables_lists[l].key);
        for (size_t i = 0; i < json_array_size(list); i++)
            change(draft, (DraftList)l, i, NULL, NULL, json_incref(json_array_get(list, i)));
        json_object_del(house, plan_tables_lists[l].key);
    }
    static const char *const members[] = {"name", "note", "run", "overrides", "background"};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        json_t *value = json_object_get(house, members[i]);
        if (value || draft_house(draft, members[i]))
            draft_set_house(draft, members[i], json_incref(value));
    }
    json_decref(house);
    Fault none = {0};
    draft_end(draft, &none);
    fault_clear(&none);
}
