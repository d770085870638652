/* Splits a segment of a wall into two, and joins two into one; the doors stay in place. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/edit/editor_state.h"
#include "plan/plan_geometry.h"

/* Returns the selected wall; NULL: another item, or several, are selected. */
static const Wall *selected_wall(const Editor *edit, size_t *index) {
    const Plan *plan = draft_plan(edit->draft);
    if (edit->id_count != 1 || draft_find(edit->draft, edit->ids[0], index) != DRAFT_WALLS)
        return NULL;
    return &plan->walls[*index];
}

/* Gives a door another place on the wall. */
static void put_door(Editor *edit, const Door *door, size_t segment, double at) {
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
            put_door(edit, door, (size_t)door->segment + 1, beyond ? door->at - half : door->at);
    }
    draft_set_points(edit->draft, wall->id, "points", points, count + 1);
    memory_free(points);
}

bool edit_split_wall(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    size_t index;
    const Wall *wall = selected_wall(edit, &index);
    if (!wall) {
        fault_add(fault, "select one wall to split it");
        return false;
    }
    size_t segment = nearest_segment(edit, wall);
    double half = vec2_distance(wall->points.at[segment], wall->points.at[segment + 1]) / 2;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        if (door->wall_index == index && (size_t)door->segment == segment && fabs(door->at - half) < door->width / 2) {
            fault_add(fault, "wall %.40s cannot be split there: door %.40s lies in the middle, move it first", wall->id,
                      door->id);
            return false;
        }
    }
    char name[EDIT_NAME];
    snprintf(name, sizeof name, "Split wall %.60s", wall->id);
    edit_gesture_open(edit, name);
    split_at(edit, wall, index, segment);
    return edit_gesture_close(edit, fault);
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
static Points points_of(const Plan *plan, const EditHandle *handle) {
    for (size_t i = 0; handle->list == DRAFT_WALLS && i < plan->wall_count; i++)
        if (strcmp(plan->walls[i].id, handle->id) == 0)
            return plan->walls[i].points;
    for (size_t i = 0; handle->list == DRAFT_ROOMS && i < plan->room_count; i++)
        if (strcmp(plan->rooms[i].id, handle->id) == 0)
            return plan->rooms[i].outline;
    size_t route = handle->list == DRAFT_ROUTES ? plan_find_route(plan, handle->id) : SIZE_MAX;
    return route != SIZE_MAX ? plan->routes[route].via : (Points){.count = 0};
}

bool edit_split_can_join(const Editor *edit) {
    static const size_t least[DRAFT_LISTS] = {[DRAFT_WALLS] = 2, [DRAFT_ROOMS] = 3, [DRAFT_ROUTES] = 0};
    EditHandle handle;
    return focused(edit, &handle) && points_of(draft_plan(edit->draft), &handle).count > least[handle.list];
}

/* Moves the doors of the segments next to a removed point to the nearest place on the new segment; if the point is
 * an end of the wall, the doors are removed with their segment. */
static void keep_doors(Editor *edit, const Points *points, size_t point, const char *wall) {
    const Plan *plan = draft_plan(edit->draft);
    bool end = point == 0 || point + 1 == points->count;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        size_t segment = (size_t)door->segment;
        if (strcmp(door->wall, wall) != 0 || segment + 1 < point)
            continue;
        if (segment > point) {
            put_door(edit, door, segment - 1, door->at);
        } else if (end) {
            draft_remove(edit->draft, door->id);
        } else {
            Vec2 from, to, a = points->at[point - 1], b = points->at[point + 1];
            plan_geometry_door_ends(plan, door, &from, &to);
            Vec2 middle = vec2_scale(vec2_add(from, to), 0.5);
            put_door(edit, door, point - 1, vec2_dot(vec2_sub(middle, a), vec2_unit(vec2_sub(b, a))));
        }
    }
}

bool edit_split_join(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    char name[EDIT_NAME], thing[EDIT_NAME];
    EditHandle handle;
    if (!focused(edit, &handle))
        return false;
    Points points = points_of(plan, &handle);
    bool closed = handle.list == DRAFT_WALLS && vec2_distance(points.at[0], points.at[points.count - 1]) < 1e-9;
    if (closed && handle.index == 0) {
        fault_add(fault, "a closed wall keeps the point where it begins");
        return false;
    }
    Vec2 *rest = memory_zeroed(points.count, sizeof *rest);
    size_t count = 0;
    for (size_t i = 0; i < points.count; i++)
        if (i != handle.index)
            rest[count++] = points.at[i];
    edit_select_name(edit, handle.id, thing);
    snprintf(name, sizeof name, "Remove point of %.80s", thing);
    edit_gesture_open(edit, name);
    if (handle.list == DRAFT_WALLS)
        keep_doors(edit, &points, handle.index, handle.id);
    const char *member = handle.list == DRAFT_WALLS ? "points" : handle.list == DRAFT_ROOMS ? "outline" : "via";
    draft_set_points(edit->draft, handle.id, member, rest, count);
    memory_free(rest);
    edit->handle = -1;
    return edit_gesture_close(edit, fault);
}
