#include "laboratory/edit/action.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "plan/draft_clip.h"
#include "laboratory/edit/drag.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/handle.h"
#include "laboratory/edit/select.h"
#include "laboratory/edit/shape.h"
#include "plan/plan_geometry.h"

static const double APART =
    0.30; /* m, to the right and downwards: offset of a copy that is pasted without the pointer */

static bool is_anything(const Editor *edit, Fault *fault) {
    if (edit->id_count)
        return true;
    fault_add(fault, "nothing is selected: click an item, or press Tab to select the next one");
    return false;
}

/* Opens an undo step; `format` has one "%.100s" for the names of the selected items. */
static void open_step(Editor *edit, const char *format) {
    char name[EDIT_NAME], items[EDIT_NAME];
    edit_select_names(edit, items);
    snprintf(name, sizeof name, format, items);
    edit_gesture_begin_step(edit, name);
}

/* Moving and turning ------------------------------------------------------------------------------------------------
 */

/* Moves a handle by setting its fields as if they were typed. */
static void nudge_fields(Editor *edit, Vec2 by) {
    EditField *fields = edit->fields;
    const EditHandle *grip = &edit->grip;
    size_t x = grip->grip == GRIP_POINT && edit->field_count == 4 ? 2 : 0;
    if (grip->list == DRAFT_DOORS) {
        const Plan *plan = &edit->plan_before;
        const Vec2 *ends = plan->walls[edit->now.wall].points.at + edit->now.segment;
        double along = vec2_dot(by, vec2_unit(vec2_sub(ends[1], ends[0])));
        bool wider = grip->grip == GRIP_EDGE;
        fields[wider].value += wider && grip->index == 0 ? -along : along;
        fields[wider].typed = fields[wider].moved = true;
        return;
    }
    if (grip->grip == GRIP_TURN) {
        fields[0].value += fabs(by.x) > fabs(by.y) ? -by.x * 100 : by.y * 100; /* one degree per centimetre */
        fields[0].typed = fields[0].moved = true;
        return;
    }
    double widen[2] = {by.x, by.y};
    if (grip->grip == GRIP_CORNER) {
        Vec2 own = vec2_unturn(by, snap_heading(edit->now.angle));
        widen[0] = grip->index == 1 || grip->index == 2 ? own.x : -own.x;
        widen[1] = grip->index >= 2 ? own.y : -own.y;
    }
    for (size_t k = 0; k < 2; k++) {
        fields[x + k].value = snap_tidy(fields[x + k].value + widen[k]);
        fields[x + k].typed = fields[x + k].moved = true;
    }
}

static bool nudge_handle(Editor *edit, Vec2 by, Fault *fault) {
    EditHandle handles[EDIT_HANDLES];
    size_t count = edit_handle_list(edit, draft_plan(edit->draft), handles);
    int handle = edit->handle;
    if ((size_t)handle >= count)
        return false;
    edit_drag_begin(edit, &handles[handle], GRAB_KEYS);
    nudge_fields(edit, by);
    edit_gesture_update(edit);
    bool good = !edit->refusal && edit_gesture_end_valid(edit);
    if (!good) {
        fault_add(fault, "%s", edit->refusal ? edit->refusal : "the item cannot be moved there");
        edit_gesture_cancel(edit);
    }
    edit->handle = handle;
    return good;
}

bool edit_action_nudge(Editor *edit, Vec2 by, Fault *fault) {
    if (!is_anything(edit, fault))
        return false;
    if (edit->handle >= 0)
        return nudge_handle(edit, by, fault);
    uint64_t before = draft_revision(edit->draft);
    open_step(edit, "Nudge %.100s");
    edit_shape_move(edit, draft_plan(edit->draft), by);
    if (!edit_gesture_end_step(edit, fault))
        return false;
    if (draft_revision(edit->draft) != before)
        return true;
    fault_add(fault, "a door can only move along its wall");
    return false;
}

bool edit_action_turn(Editor *edit, double by, Fault *fault) {
    size_t index, turned = 0;
    if (!is_anything(edit, fault))
        return false;
    open_step(edit, "Turn %.100s");
    for (size_t i = 0; i < edit->id_count; i++) {
        DraftList list = draft_find(edit->draft, edit->ids[i], &index);
        const char *member = list == DRAFT_FURNITURE ? "angle" : list == DRAFT_PEOPLE ? "heading" : NULL;
        if (!member)
            continue;
        double is = json_number_value(json_object_get(draft_element(edit->draft, edit->ids[i]), member));
        double angle = snap_tidy(remainder(is + by, 360));
        draft_set_number(edit->draft, edit->ids[i], member, angle <= -180 ? 180 : angle);
        turned++;
    }
    if (!turned)
        fault_add(fault, "only furniture and people can be turned");
    return edit_gesture_end_step(edit, fault) && turned;
}

/* Toppling --------------------------------------------------------------------------------------------------------- */

static bool may_topple(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    size_t index, count = 0;
    char name[EDIT_NAME];
    for (size_t i = 0; i < edit->id_count; i++) {
        if (draft_find(edit->draft, edit->ids[i], &index) != DRAFT_FURNITURE)
            continue;
        count += plan->furniture[index].topples != TOPPLE_NO;
        if (plan->furniture[index].topples != TOPPLE_NO)
            continue;
        edit_select_name(edit, edit->ids[i], name);
        fault_add(fault, "%s does not fall: choose to which side on the panel, at \"falls to\"", name);
    }
    if (!count && !fault->count)
        fault_add(fault, "only furniture can topple");
    return count;
}

bool edit_action_can_topple(Editor *edit) {
    Fault fault = {0};
    bool can = may_topple(edit, &fault);
    fault_clear(&fault);
    return can;
}

bool edit_action_topple(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    size_t index;
    if (!is_anything(edit, fault) || !may_topple(edit, fault))
        return false;
    bool lies = true;
    for (size_t i = 0; i < edit->id_count; i++)
        if (draft_find(edit->draft, edit->ids[i], &index) == DRAFT_FURNITURE &&
            plan->furniture[index].topples != TOPPLE_NO)
            lies &= plan->furniture[index].toppled;
    open_step(edit, lies ? "Stand up %.100s" : "Topple %.100s");
    for (size_t i = 0; i < edit->id_count; i++)
        if (draft_find(edit->draft, edit->ids[i], &index) == DRAFT_FURNITURE &&
            plan->furniture[index].topples != TOPPLE_NO)
            draft_set(edit->draft, edit->ids[i], "toppled", json_boolean(!lies));
    return edit_gesture_end_step(edit, fault);
}

/* Splitting a wall ------------------------------------------------------------------------------------------------- */

/* Returns the selected wall; NULL: another item, or several, are selected. */
static const Wall *selected_wall(const Editor *edit, size_t *index) {
    const Plan *plan = draft_plan(edit->draft);
    if (edit->id_count != 1 || draft_find(edit->draft, edit->ids[0], index) != DRAFT_WALLS)
        return NULL;
    return &plan->walls[*index];
}

/* Gives a door another place on the wall. */
static void move_door(Editor *edit, const Door *door, size_t segment, double at) {
    draft_set(edit->draft, door->id, "segment", json_integer((json_int_t)segment));
    draft_set_number(edit->draft, door->id, "at", snap_tidy(at));
}

static size_t nearest_segment(const Editor *edit, const Wall *wall) {
    size_t nearest = 0;
    double least = HUGE_VAL;
    for (size_t s = 0; s + 1 < wall->points.count; s++) {
        const Vec2 *ends = wall->points.at + s;
        double distance = vec2_distance(edit->pointer.at, vec2_nearest_on_segment(edit->pointer.at, ends[0], ends[1]));
        if (distance >= least)
            continue;
        least = distance;
        nearest = s;
    }
    return nearest;
}

static void split_at(Editor *edit, const Wall *wall, size_t index, size_t segment) {
    const Plan *plan = draft_plan(edit->draft);
    const Vec2 *at = wall->points.at;
    size_t count = wall->points.count;
    Vec2 *points = memory_zeroed(count + 1, sizeof *points);
    Vec2 middle = vec2_scale(vec2_add(at[segment], at[segment + 1]), 0.5);
    double half = vec2_distance(at[segment], at[segment + 1]) / 2;
    memcpy(points, at, (segment + 1) * sizeof *points);
    points[segment + 1] = vec2(snap_tidy(middle.x), snap_tidy(middle.y));
    memcpy(points + segment + 2, at + segment + 1, (count - segment - 1) * sizeof *points);
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        bool beyond = (size_t)door->segment == segment && door->at > half;
        if (door->wall_index == index && (beyond || (size_t)door->segment > segment))
            move_door(edit, door, (size_t)door->segment + 1, beyond ? door->at - half : door->at);
    }
    draft_set_points(edit->draft, wall->id, "points", points, count + 1);
    memory_free(points);
}

bool edit_action_split(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    size_t index;
    const Wall *wall = selected_wall(edit, &index);
    if (!wall) {
        fault_add(fault, "select one wall to split it");
        return false;
    }
    char name[EDIT_NAME], wall_name[EDIT_NAME];
    size_t segment = nearest_segment(edit, wall);
    double half = vec2_distance(wall->points.at[segment], wall->points.at[segment + 1]) / 2;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        if (door->wall_index == index && (size_t)door->segment == segment && fabs(door->at - half) < door->width / 2) {
            edit_select_name(edit, door->id, name);
            fault_add(fault, "the wall cannot be split there: the %s lies in the middle; move the door first", name);
            return false;
        }
    }
    Vec2 middle = vec2_scale(vec2_add(wall->points.at[segment], wall->points.at[segment + 1]), 0.5);
    edit_select_name_at(edit, plan, wall->id, &middle, wall_name);
    snprintf(name, sizeof name, "Split %.100s", wall_name);
    edit_gesture_begin_step(edit, name);
    split_at(edit, wall, index, segment);
    return edit_gesture_end_step(edit, fault);
}

/* Removing a point ------------------------------------------------------------------------------------------------ */

/* Finds the handle that has the keyboard focus; false: none. */
static bool focused(const Editor *edit, EditHandle *handle) {
    EditHandle handles[EDIT_HANDLES];
    size_t count = edit_handle_list(edit, draft_plan(edit->draft), handles);
    if (edit->handle < 0 || (size_t)edit->handle >= count)
        return false;
    *handle = handles[edit->handle];
    return handle->grip == GRIP_POINT;
}

/* Returns the points of an element; empty if it has no list of points. */
static Points points_of_handle(const Plan *plan, const EditHandle *handle) {
    for (size_t i = 0; handle->list == DRAFT_WALLS && i < plan->wall_count; i++)
        if (strcmp(plan->walls[i].id, handle->id) == 0)
            return plan->walls[i].points;
    for (size_t i = 0; handle->list == DRAFT_ROOMS && i < plan->room_count; i++)
        if (strcmp(plan->rooms[i].id, handle->id) == 0)
            return plan->rooms[i].outline;
    size_t route = handle->list == DRAFT_ROUTES ? plan_find_route(plan, handle->id) : SIZE_MAX;
    return route != SIZE_MAX ? plan->routes[route].via : (Points){.count = 0};
}

/* True if the focused point can be removed. */
static bool can_join(const Editor *edit) {
    static const size_t least[DRAFT_LISTS] = {[DRAFT_WALLS] = 2, [DRAFT_ROOMS] = 3, [DRAFT_ROUTES] = 0};
    EditHandle handle;
    return focused(edit, &handle) && points_of_handle(draft_plan(edit->draft), &handle).count > least[handle.list];
}

/* Moves the doors of the segments next to a removed point to the nearest place on the new segment; if the point is
 * an end of the wall, the doors are removed with their segment. */
static void move_doors(Editor *edit, const Points *points, size_t point, const char *wall) {
    const Plan *plan = draft_plan(edit->draft);
    bool end = point == 0 || point + 1 == points->count;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        size_t segment = (size_t)door->segment;
        if (strcmp(door->wall, wall) != 0 || segment + 1 < point)
            continue;
        if (segment > point) {
            move_door(edit, door, segment - 1, door->at);
        } else if (end) {
            draft_remove(edit->draft, door->id);
        } else {
            Vec2 from, to, a = points->at[point - 1], b = points->at[point + 1];
            plan_geometry_door_ends(plan, door, &from, &to);
            Vec2 middle = vec2_scale(vec2_add(from, to), 0.5);
            move_door(edit, door, point - 1, vec2_dot(vec2_sub(middle, a), vec2_unit(vec2_sub(b, a))));
        }
    }
}

/* Removes the point that has the keyboard focus, so that two segments become one. */
static bool join(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    char name[EDIT_NAME], item[EDIT_NAME];
    EditHandle handle;
    if (!focused(edit, &handle))
        return false;
    Points points = points_of_handle(plan, &handle);
    bool closed = handle.list == DRAFT_WALLS && vec2_distance(points.at[0], points.at[points.count - 1]) < 1e-9;
    if (closed && handle.index == 0) {
        fault_add(fault, "the first point of a closed wall cannot be removed");
        return false;
    }
    Vec2 *rest = memory_zeroed(points.count, sizeof *rest);
    size_t count = 0;
    for (size_t i = 0; i < points.count; i++)
        if (i != handle.index)
            rest[count++] = points.at[i];
    edit_select_name(edit, handle.id, item);
    snprintf(name, sizeof name, "Remove a point of %.80s", item);
    edit_gesture_begin_step(edit, name);
    if (handle.list == DRAFT_WALLS)
        move_doors(edit, &points, handle.index, handle.id);
    const char *member = handle.list == DRAFT_WALLS ? "points" : handle.list == DRAFT_ROOMS ? "outline" : "via";
    draft_set_points(edit->draft, handle.id, member, rest, count);
    memory_free(rest);
    edit->handle = -1;
    return edit_gesture_end_step(edit, fault);
}

/* Removing --------------------------------------------------------------------------------------------------------- */

bool edit_action_remove(Editor *edit, Fault *fault) {
    if (!edit->id_count && edit->measure_count) {
        edit->measure_count = 0;
        return true;
    }
    if (!is_anything(edit, fault))
        return false;
    if (edit->handle >= 0 && can_join(edit))
        return join(edit, fault);
    open_step(edit, "Remove %.100s");
    for (size_t i = 0; i < edit->id_count; i++)
        draft_remove(edit->draft, edit->ids[i]);
    return edit_gesture_end_step(edit, fault);
}

/* Copies ----------------------------------------------------------------------------------------------------------- */

char *edit_action_copy(const Editor *edit) {
    return edit->id_count ? draft_clip_copy(edit->draft, (const char *const *)edit->ids, edit->id_count) : NULL;
}

static bool paste(Editor *edit, const char *name, const char *text, Vec2 by, Fault *fault) {
    const char **ids = NULL;
    size_t count = 0;
    edit_gesture_begin_step(edit, name);
    if (!draft_clip_paste(edit->draft, text, by, &ids, &count, fault)) {
        draft_cancel(edit->draft);
        return false;
    }
    Fault own = {0};
    bool good = edit_gesture_end_step(edit, &own);
    for (size_t i = 0; i < own.count; i++)
        fault_add(fault, "the pasted items cannot be placed here: %s", own.lines[i]);
    fault_clear(&own);
    for (size_t i = 0; good && i < count; i++) {
        if (i == 0)
            edit_select_only(edit, ids[i]);
        else
            edit_select_toggle(edit, ids[i]);
    }
    memory_free(ids);
    return good;
}

bool edit_action_duplicate(Editor *edit, Fault *fault) {
    char name[EDIT_NAME], items[EDIT_NAME];
    if (!is_anything(edit, fault))
        return false;
    edit_select_names(edit, items);
    snprintf(name, sizeof name, "Duplicate %.100s", items);
    char *text = edit_action_copy(edit);
    bool good = text && paste(edit, name, text, vec2(APART, -APART), fault);
    memory_free(text);
    return good;
}

/* Extends the box by all places within a value: pairs of numbers at any depth. */
static Box include_places(Box box, const json_t *value) {
    size_t i;
    json_t *inner;
    const char *key;
    if (json_array_size(value) == 2 && json_is_number(json_array_get(value, 0)) &&
        json_is_number(json_array_get(value, 1)))
        return box_include(
            box, vec2(json_number_value(json_array_get(value, 0)), json_number_value(json_array_get(value, 1))));
    json_array_foreach(value, i, inner) box = include_places(box, inner);
    json_object_foreach((json_t *)value, key, inner) {
        if (strcmp(key, "size") != 0)
            box = include_places(box, inner);
    }
    return box;
}

/* Returns the offset of pasted pieces: their middle moves to the pointer. Without a pointer, or close to the
 * originals, each copy is placed APART farther to the right and below. */
static Vec2 paste_by(Editor *edit, const char *text, Box box) {
    Vec2 to = vec2_sub(edit->pointer.at, vec2_scale(vec2_add(box.low, box.high), 0.5));
    Vec2 by = vec2(round(to.x / SNAP_GRID) * SNAP_GRID, round(to.y / SNAP_GRID) * SNAP_GRID);
    if (edit->seen && !edit->pointer.nowhere && vec2_length(by) >= APART)
        return by;
    uint64_t digest = digest_bytes(DIGEST_START, text, strlen(text));
    edit->copies = digest == edit->pasted ? edit->copies + 1 : 1;
    edit->pasted = digest;
    return vec2(edit->copies * APART, -edit->copies * APART);
}

bool edit_action_paste(Editor *edit, const char *text, Fault *fault) {
    json_t *pieces = json_loads(text, 0, NULL);
    Box box = include_places(box_empty(), pieces);
    Vec2 by = box.low.x <= box.high.x ? paste_by(edit, text, box) : vec2(0, 0);
    json_decref(pieces);
    return paste(edit, "Paste", text, by, fault);
}
