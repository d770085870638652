#include "laboratory/edit/select.h"

#include <stdio.h>
#include <string.h>

#include "plan/plan_geometry.h"
#include "result/names.h"

/* Items and ids --------------------------------------------------------------------------------------------------- */

const char *edit_select_id(const Editor *edit, Item item) {
    const House *house = edit->scene.scenery.house;
    size_t index;
    if (!house || item.kind == HOUSE_HAZARD || item.index >= house_item_count(house, NULL, item.kind))
        return "";
    const char *id = house_item_id(house, item);
    return draft_find(edit->draft, id, &index) < DRAFT_LISTS ? id
                                                             : ""; /* neither a person of a crowd nor a removed item */
}

Item edit_select_item(const Editor *edit, const char *id) {
    static const int kinds[DRAFT_LISTS] = {[DRAFT_WALLS] = HOUSE_WALL,
                                           [DRAFT_DOORS] = HOUSE_DOOR,
                                           [DRAFT_FURNITURE] = HOUSE_FURNITURE,
                                           [DRAFT_EXITS] = HOUSE_EXIT,
                                           [DRAFT_PEOPLE] = HOUSE_PERSON};
    size_t index;
    DraftList list = draft_find(edit->draft, id, &index);
    if (!edit->scene.scenery.house || list == DRAFT_LISTS || !kinds[list])
        return (Item){0, 0};
    return house_item_find(edit->scene.scenery.house, kinds[list], id);
}

/* The list --------------------------------------------------------------------------------------------------------- */

static size_t find(const Editor *edit, const char *id) {
    size_t i = 0;
    while (i < edit->id_count && strcmp(edit->ids[i], id) != 0)
        i++;
    return i;
}

static void forget(Editor *edit, size_t i) {
    memory_free(edit->ids[i]);
    memmove(edit->ids + i, edit->ids + i + 1, (edit->id_count - i - 1) * sizeof *edit->ids);
    edit->id_count--;
}

static void clear(Editor *edit) {
    while (edit->id_count)
        forget(edit, edit->id_count - 1);
    edit->handle = -1;
}

static void append(Editor *edit, const char *id) {
    Text copy = {0};
    text_add(&copy, id);
    edit->ids = memory_reserve(edit->ids, &edit->id_capacity, edit->id_count + 1, sizeof *edit->ids);
    edit->ids[edit->id_count++] = copy.text;
}

/* Sets `selected` to the last item of the selection that the displayed house has. */
static void store_selected(Editor *edit) {
    edit->synced = edit->id_count ? edit_select_item(edit, edit->ids[edit->id_count - 1]) : (Item){0, 0};
    edit->selected = edit->synced;
}

/* Removes ids of removed items; true if there were any. */
static bool forget_gone(Editor *edit) {
    size_t index, before = edit->id_count;
    for (size_t i = edit->id_count; i > 0; i--)
        if (draft_find(edit->draft, edit->ids[i - 1], &index) == DRAFT_LISTS)
            forget(edit, i - 1);
    if (edit->id_count != before)
        edit->handle = -1;
    return edit->id_count != before;
}

void edit_select_sync(Editor *edit) {
    if (forget_gone(edit))
        store_selected(edit);
    const char *id = edit_select_id(edit, edit->selected);
    const char *last = edit->id_count ? edit->ids[edit->id_count - 1] : "";
    if (strcmp(id, last) == 0)
        return;
    bool shown = edit_select_item(edit, last).kind != HOUSE_NOTHING;
    if (!edit->selected.kind && !shown && *last) {
        edit->synced = (Item){0, 0}; /* the item is not displayed yet, or cannot be selected alone */
        return;
    }
    if (!edit->selected.kind && shown && !edit->synced.kind) {
        store_selected(edit); /* the item is displayed now */
        return;
    }
    char *copy = text_copy(id); /* `id` may point into the list that is cleared */
    clear(edit);
    if (*copy)
        append(edit, copy);
    memory_free(copy);
    edit->synced = edit->selected;
}

void edit_select_only(Editor *edit, const char *id) {
    char *copy = text_copy(id ? id : "");
    if (edit->id_count != 1 || strcmp(edit->ids[0], copy) != 0)
        clear(edit);
    if (*copy && !edit->id_count)
        append(edit, copy);
    memory_free(copy);
    store_selected(edit);
}

void edit_select_toggle(Editor *edit, const char *id) {
    size_t i = find(edit, id);
    edit->handle = -1;
    if (i < edit->id_count)
        forget(edit, i);
    else
        append(edit, id);
    store_selected(edit);
}

void edit_select_prune(Editor *edit) {
    forget_gone(edit);
    store_selected(edit);
}

bool edit_select_has(const Editor *edit, const char *id) {
    return find(edit, id) < edit->id_count;
}

const char *edit_select_fixed(const Editor *edit) {
    static const char *const fixed[DRAFT_LISTS] = {
        [DRAFT_WALLS] = "walls", [DRAFT_DOORS] = "doors", [DRAFT_ROOMS] = "rooms", [DRAFT_EXITS] = "exits"};
    size_t index;
    for (size_t i = 0; edit->fixed && i < edit->id_count; i++) {
        DraftList list = draft_find(edit->draft, edit->ids[i], &index);
        if (list < DRAFT_LISTS && fixed[list])
            return fixed[list];
    }
    return NULL;
}

/* Several items --------------------------------------------------------------------------------------------------- */

static Box box_of(const Vec2 *points, size_t count) {
    Box box = box_empty();
    for (size_t i = 0; i < count; i++)
        box = box_include(box, points[i]);
    return box;
}

/* Finds the box of an element of a list; false: the element has no place. */
static bool find_box(const Plan *plan, DraftList list, size_t i, Box *box) {
    Vec2 corners[4];
    switch (list) {
    case DRAFT_WALLS:
        *box = box_of(plan->walls[i].points.at, plan->walls[i].points.count);
        return true;
    case DRAFT_DOORS:
        plan_geometry_door_ends(plan, &plan->doors[i], &corners[0], &corners[1]);
        *box = box_of(corners, 2);
        return true;
    case DRAFT_FURNITURE:
        plan_geometry_corners(&plan->furniture[i], corners);
        *box = box_of(corners, 4);
        return true;
    case DRAFT_ROOMS:
        *box = box_of(plan->rooms[i].outline.at, plan->rooms[i].outline.count);
        return true;
    case DRAFT_EXITS:
        *box = box_of((Vec2[]){plan->exits[i].from, plan->exits[i].to}, 2);
        return true;
    case DRAFT_PEOPLE:
        *box = box_around(plan->people[i].at, 0);
        return true;
    case DRAFT_CROWDS:
        *box = box_of(plan->crowds[i].area.at, plan->crowds[i].area.count);
        return true;
    default:
        return false;
    }
}

void edit_select_within(Editor *edit, Box within, bool more) {
    const Plan *plan = draft_plan(edit->draft);
    Box box;
    if (!more)
        clear(edit);
    for (int l = 0; l < DRAFT_LISTS; l++)
        for (size_t i = 0; i < draft_count(edit->draft, (DraftList)l); i++) {
            const char *id = json_string_value(json_object_get(draft_at(edit->draft, (DraftList)l, i), "id"));
            if (find_box(plan, (DraftList)l, i, &box) && box_holds(within, box.low) && box_holds(within, box.high) &&
                find(edit, id) == edit->id_count)
                append(edit, id);
        }
    store_selected(edit);
}

void edit_select_all(Editor *edit) {
    edit_select_within(edit, (Box){{-HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL}}, false);
}

/* Pointing -------------------------------------------------------------------------------------------------------- */

static bool holds(const Points *points, Vec2 p) {
    bool inside = false;
    for (size_t i = 0, j = points->count - 1; i < points->count; j = i++) {
        Vec2 a = points->at[i], b = points->at[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

/* Returns the id of the smallest item of the draft at a place, walls last; NULL: none. Finds items that no run
 * displays yet. */
static const char *find_at(const Editor *edit, Vec2 at) {
    static const DraftList order[] = {DRAFT_PEOPLE, DRAFT_DOORS, DRAFT_FURNITURE, DRAFT_EXITS};
    const Plan *plan = draft_plan(edit->draft);
    for (size_t k = 0; k < sizeof order / sizeof *order; k++)
        for (size_t i = draft_count(edit->draft, order[k]); i > 0; i--) {
            Vec2 corners[4];
            Box box;
            if (!find_box(plan, order[k], i - 1, &box) || !box_holds(box_expand(box, edit->pointer.reach), at))
                continue;
            if (order[k] == DRAFT_FURNITURE)
                plan_geometry_corners(&plan->furniture[i - 1], corners);
            if (order[k] == DRAFT_FURNITURE && !holds(&(Points){corners, 4}, at))
                continue;
            return json_string_value(json_object_get(draft_at(edit->draft, order[k], i - 1), "id"));
        }
    SnapWall wall;
    if (snap_wall(plan, at, &wall) &&
        wall.distance <= real_max(edit->pointer.reach, plan->walls[wall.wall].thickness / 2))
        return plan->walls[wall.wall].id;
    return NULL;
}

const char *edit_select_at(Editor *edit, Vec2 at) {
    const Plan *plan = draft_plan(edit->draft);
    const EditorScene *scene = &edit->scene;
    bool shown = scene->scenery.house && scene->revision == draft_revision(edit->draft);
    const char *id =
        shown ? edit_select_id(edit, house_item_at(&scene->scenery, at, scene->time, (Item){0, 0})) : find_at(edit, at);
    if (id && *id)
        return id;
    for (size_t r = plan->room_count; r > 0; r--)
        if (holds(&plan->rooms[r - 1].outline, at))
            return plan->rooms[r - 1].id;
    return NULL;
}

/* Names ----------------------------------------------------------------------------------------------------------- */

/* Returns the name of a wall, a door or a piece of furniture; NULL: the id is of something else. */
static const char *name_of(const Plan *plan, const char *id, const Vec2 *at, Arena *arena) {
    for (size_t w = 0; w < plan->wall_count; w++)
        if (strcmp(plan->walls[w].id, id) == 0)
            return at ? names_wall_at(plan, w, *at, arena) : names_wall(plan, w, arena);
    for (size_t d = 0; d < plan->door_count; d++)
        if (strcmp(plan->doors[d].id, id) == 0)
            return names_door(plan, d, arena);
    for (size_t f = 0; f < plan->furniture_count; f++)
        if (strcmp(plan->furniture[f].id, id) == 0)
            return *plan->furniture[f].name ? plan->furniture[f].name : "furniture";
    return NULL;
}

void edit_select_snap_name(const Plan *plan, const char *id, Vec2 at, char name[SNAP_NAME]) {
    Arena arena = {0};
    const char *called = name_of(plan, id, &at, &arena);
    snprintf(name, SNAP_NAME, "%s", called ? called : id);
    arena_clear(&arena);
}

void edit_select_name_at(const Editor *edit, const Plan *plan, const char *id, const Vec2 *at, char name[EDIT_NAME]) {
    static const char *const kind_names[DRAFT_LISTS] = {"wall", "door",   "furniture", "room",
                                                        "exit", "person", "crowd",     "route"};
    size_t index;
    Arena arena = {0};
    const House *house = edit->scene.scenery.house;
    DraftList list = draft_find(edit->draft, id, &index);
    const char *called = name_of(plan, id, at, &arena);
    if (!called && list == DRAFT_ROOMS)
        called = json_string_value(json_object_get(draft_at(edit->draft, list, index), "name"));
    Item item = list == DRAFT_PEOPLE ? edit_select_item(edit, id) : (Item){0, 0};
    if (called && *called)
        snprintf(name, EDIT_NAME, "%.100s", called);
    else if (item.kind)
        snprintf(name, EDIT_NAME, "person %.60s", names_person(house, item.index, &arena));
    else if (list == DRAFT_EXITS || list == DRAFT_CROWDS || list == DRAFT_ROUTES)
        snprintf(name, EDIT_NAME, "%s %.60s", kind_names[list], id);
    else
        snprintf(name, EDIT_NAME, "%s", list < DRAFT_LISTS ? kind_names[list] : "item");
    arena_clear(&arena);
}

void edit_select_name(const Editor *edit, const char *id, char name[EDIT_NAME]) {
    edit_select_name_at(edit, draft_plan(edit->draft), id, NULL, name);
}

char *edit_select_named(const Editor *edit, const char *text) {
    Arena arena = {0};
    char *named = text_copy(names_plan_text(draft_plan(edit->draft), edit->scene.scenery.house, text, &arena));
    arena_clear(&arena);
    return named;
}

void edit_select_names(const Editor *edit, char name[EDIT_NAME]) {
    if (edit->id_count == 1)
        edit_select_name(edit, edit->ids[0], name);
    else
        snprintf(name, EDIT_NAME, "%zu items", edit->id_count);
}
