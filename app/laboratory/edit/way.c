/* Draws exits, rooms and routes. */
#include <stdio.h>

#include "laboratory/edit/editor_state.h"
#include "plan/plan_geometry.h"

static json_t *point(Vec2 at) {
    return json_pack("[o, o]", json_number(at.x), json_number(at.y));
}

static json_t *points(const Editor *edit, size_t most) {
    const EditChain *chain = &edit->chain;
    json_t *list = json_array();
    for (size_t i = 0; i < chain->count; i++)
        json_array_append_new(list, point(chain->points[i]));
    if (chain->floating && json_array_size(list) < most)
        json_array_append_new(list, point(edit->now.at));
    return list;
}

static void add(Editor *edit, DraftList list, json_t *element) {
    snprintf(edit->made, EDIT_NAME, "%s", draft_add(edit->draft, list, element));
}

void edit_way_make_exit(Editor *edit) {
    if (edit->chain.count + edit->chain.floating < 2)
        return;
    Vec2 to = edit->chain.count > 1 ? edit->chain.points[1] : edit->now.at;
    add(edit, DRAFT_EXITS, json_pack("{s:o, s:o}", "from", point(edit->chain.points[0]), "to", point(to)));
}

/* Returns the door whose opening, enlarged by a reach, contains a place; NULL: none. */
static const Door *door_at(const Plan *plan, Vec2 at, double reach) {
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        double half = plan->walls[plan->doors[d].wall_index].thickness / 2;
        Vec2 foot = vec2_nearest_on_segment(at, from, to);
        bool beside = vec2_distance(foot, from) < reach || vec2_distance(foot, to) < reach;
        if (!beside && vec2_distance(at, foot) <= real_max(half, reach))
            return &plan->doors[d];
    }
    return NULL;
}

bool edit_way_across(Editor *edit) {
    const Plan *plan = draft_plan(edit->draft);
    const Door *door = door_at(plan, edit->pointer.at, edit->pointer.reach);
    if (!door)
        return false;
    Vec2 from, to;
    char name[EDIT_NAME];
    plan_geometry_door_ends(plan, door, &from, &to);
    snprintf(name, sizeof name, "Place exit across door %.60s", door->id);
    edit_gesture_open(edit, name);
    add(edit, DRAFT_EXITS,
        json_pack("{s:o, s:o}", "from", point(vec2(snap_tidy(from.x), snap_tidy(from.y))), "to",
                  point(vec2(snap_tidy(to.x), snap_tidy(to.y)))));
    Fault fault = {0};
    if (edit_gesture_close(edit, &fault))
        edit_select_only(edit, edit->made);
    fault_clear(&fault);
    return true;
}

void edit_way_make_room(Editor *edit) {
    json_t *outline = points(edit, SIZE_MAX);
    if (json_array_size(outline) < 3)
        json_decref(outline);
    else
        add(edit, DRAFT_ROOMS, json_pack("{s:o}", "outline", outline));
}

/* Routes ---------------------------------------------------------------------------------------------------------- */

const char *edit_way_person(const Editor *edit) {
    const Plan *plan = edit->gesture ? &edit->begun : draft_plan(edit->draft);
    for (size_t i = edit->id_count; i > 0; i--) {
        size_t person = plan_find_person(plan, edit->ids[i - 1]);
        if (person != SIZE_MAX)
            return plan->people[person].id;
    }
    return plan->person_count ? plan->people[0].id : NULL;
}

/* Returns the exit at the pointer; NULL: none. */
static const char *exit_at(const Editor *edit) {
    for (size_t e = 0; e < edit->begun.exit_count; e++) {
        const Exit *exit = &edit->begun.exits[e];
        if (vec2_distance(edit->now.at, vec2_nearest_on_segment(edit->now.at, exit->from, exit->to)) <=
            edit->pointer.reach)
            return exit->id;
    }
    return NULL;
}

void edit_way_find_exit(Editor *edit) {
    const char *exit = exit_at(edit);
    snprintf(edit->chain.exit, EDIT_NAME, "%s", exit ? exit : "");
}

void edit_way_make_route(Editor *edit) {
    EditChain *chain = &edit->chain;
    const char *person = edit_way_person(edit);
    if (!person)
        return;
    json_t *via = json_array();
    for (size_t i = 0; i < chain->count; i++)
        json_array_append_new(via, point(chain->points[i]));
    if (chain->floating && !*chain->exit)
        json_array_append_new(via, point(edit->now.at));
    const PlanRoute *route = plan_route_of(&edit->begun, person);
    const char *id = route ? route->id : draft_add(edit->draft, DRAFT_ROUTES, json_pack("{s:[s]}", "people", person));
    draft_set(edit->draft, id, "via", via);
    if (*chain->exit)
        draft_set_text(edit->draft, id, "exit", chain->exit);
}
