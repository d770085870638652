#include "laboratory/edit/shape.h"

#include <math.h>
#include <string.h>

#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/select.h"

static const double JOINED = 1e-6; /* m: points of walls closer than this form one corner */

enum { FIELD_LENGTH, FIELD_ANGLE, FIELD_X, FIELD_Y };

/* Places that move, and their targets. */
typedef struct Shift {
    Vec2 *from, *to; /* (count) m */
    size_t count;
} Shift;

/* Returns the points of the dragged element before the gesture; an exit's two points are stored in `ends`. */
static Points points_before(const Editor *edit, Vec2 ends[2]) {
    const Plan *plan = &edit->plan_before;
    const char *id = edit->dragged_id;
    for (size_t i = 0; i < plan->wall_count; i++)
        if (strcmp(plan->walls[i].id, id) == 0)
            return plan->walls[i].points;
    for (size_t i = 0; i < plan->room_count; i++)
        if (strcmp(plan->rooms[i].id, id) == 0)
            return plan->rooms[i].outline;
    for (size_t i = 0; i < plan->route_count; i++)
        if (strcmp(plan->routes[i].id, id) == 0)
            return plan->routes[i].via;
    for (size_t i = 0; i < plan->exit_count; i++)
        if (strcmp(plan->exits[i].id, id) == 0) {
            ends[0] = plan->exits[i].from;
            ends[1] = plan->exits[i].to;
            return (Points){ends, 2};
        }
    return (Points){.count = 0};
}

/* Returns the neighbour of the dragged point, from which lengths and angles are measured. NULL: it has none. */
static const Vec2 *neighbour(const Editor *edit, const Points *points) {
    size_t i = edit->grip.index;
    if (points->count < 2)
        return NULL;
    if (i > 0)
        return &points->at[i - 1];
    bool round = edit->grip.list == DRAFT_ROOMS;
    return round ? &points->at[points->count - 1] : &points->at[1];
}

static void update_typed_line(Editor *edit, const Vec2 *from) {
    double length = from ? vec2_distance(*from, edit->now.at) : 0;
    double angle = from ? snap_angle(vec2_sub(edit->now.at, *from)) : 0;
    bool typed = edit_field_typed(edit, FIELD_LENGTH, &length);
    typed |= edit_field_typed(edit, FIELD_ANGLE, &angle);
    if (typed && from) {
        Vec2 at = vec2_along(*from, length, snap_heading(angle));
        edit->now.at = vec2(snap_tidy(at.x), snap_tidy(at.y));
    }
    edit_field_typed(edit, FIELD_X, &edit->now.at.x);
    edit_field_typed(edit, FIELD_Y, &edit->now.at.y);
    if (from) {
        edit_field_show(edit, FIELD_LENGTH, vec2_distance(*from, edit->now.at));
        edit_field_show(edit, FIELD_ANGLE, snap_angle(vec2_sub(edit->now.at, *from)));
    }
    edit_field_show(edit, FIELD_X, edit->now.at.x);
    edit_field_show(edit, FIELD_Y, edit->now.at.y);
}

static void update_point(Editor *edit) {
    Vec2 ends[2];
    Points points = points_before(edit, ends);
    const Vec2 *from = neighbour(edit, &points);
    const char *without[] = {edit->dragged_id};
    edit->now.at = edit->keys ? edit->grip.at
                              : edit_gesture_snap(edit, (SnapAsk){.from = from,
                                                                  .along = NAN,
                                                                  .faces = edit->grip.list == DRAFT_ROOMS,
                                                                  .doors = edit->grip.list == DRAFT_EXITS,
                                                                  .without = without,
                                                                  .without_count = 1});
    if (edit->field_count > FIELD_Y) {
        update_typed_line(edit, from);
        return;
    }
    edit_field_typed(edit, 0, &edit->now.at.x);
    edit_field_typed(edit, 1, &edit->now.at.y);
    edit_field_show(edit, 0, edit->now.at.x);
    edit_field_show(edit, 1, edit->now.at.y);
}

/* True if a place is a point of any wall except this wall's own segment. */
static bool is_joined(const Plan *plan, const char *id, size_t segment, Vec2 at) {
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t i = 0; i < plan->walls[w].points.count; i++) {
            bool own = strcmp(plan->walls[w].id, id) == 0 && (i == segment || i == segment + 1);
            if (own && i > 0 && i + 1 < plan->walls[w].points.count)
                return true; /* a neighbour in the same wall */
            if (!own && vec2_distance(plan->walls[w].points.at[i], at) < JOINED)
                return true;
        }
    return false;
}

/* Moves a segment of a wall, or an exit, with the pointer; joined segments move only sideways. */
static void update_piece(Editor *edit) {
    Vec2 ends[2];
    Points points = points_before(edit, ends);
    const Vec2 *piece = points.at + edit->grip.index;
    const char *without[] = {edit->dragged_id};
    Vec2 at = edit->keys
                  ? edit->grip.at
                  : edit_gesture_snap(
                        edit, (SnapAsk){.along = NAN, .from = &edit->grip.at, .without = without, .without_count = 1});
    edit_field_typed(edit, 0, &at.x);
    edit_field_typed(edit, 1, &at.y);
    bool joined = edit->grip.grip == GRIP_SEGMENT &&
                  (is_joined(&edit->plan_before, edit->dragged_id, edit->grip.index, piece[0]) ||
                   is_joined(&edit->plan_before, edit->dragged_id, edit->grip.index, piece[1]));
    if (joined) {
        Vec2 side = vec2_left(snap_heading(snap_angle(vec2_sub(piece[1], piece[0]))));
        at = vec2_along(edit->grip.at, vec2_dot(vec2_sub(at, edit->grip.at), side), side);
        edit->snap.guide_count = 0;
    }
    edit->now.at = edit->snap.at = vec2(snap_tidy(at.x), snap_tidy(at.y));
    edit_field_show(edit, 0, edit->now.at.x);
    edit_field_show(edit, 1, edit->now.at.y);
}

void edit_shape_update(Editor *edit) {
    if (edit->grip.grip == GRIP_POINT)
        update_point(edit);
    else
        update_piece(edit);
}

/* Changing the draft ---------------------------------------------------------------------------------------------- */

/* Keeps the doors in place on a segment whose first point moves: their distance from its other end stays the same. */
static void move_doors(Editor *edit, const Plan *plan, size_t w, const Vec2 *moved) {
    const Vec2 *before = plan->walls[w].points.at;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        size_t s = (size_t)door->segment;
        if (door->wall_index != w)
            continue;
        bool begins = vec2_distance(before[s], moved[s]) > 0, ends = vec2_distance(before[s + 1], moved[s + 1]) > 0;
        double grown = vec2_distance(moved[s], moved[s + 1]) - vec2_distance(before[s], before[s + 1]);
        if (begins && !ends)
            draft_set_number(edit->draft, door->id, "at", snap_tidy(door->at + grown));
    }
}

static Vec2 shifted(const Shift *shift, Vec2 at) {
    for (size_t i = 0; i < shift->count; i++)
        if (vec2_distance(at, shift->from[i]) < JOINED)
            return shift->to[i];
    return at;
}

static void shift_wall(Editor *edit, const Plan *plan, size_t w, const Shift *shift) {
    const Wall *wall = &plan->walls[w];
    Vec2 *moved = memory_zeroed(wall->points.count, sizeof *moved);
    bool any = false;
    for (size_t i = 0; i < wall->points.count; i++) {
        moved[i] = shifted(shift, wall->points.at[i]);
        any |= vec2_distance(moved[i], wall->points.at[i]) > 0;
    }
    if (any) {
        draft_set_points(edit->draft, wall->id, "points", moved, wall->points.count);
        move_doors(edit, plan, w, moved);
    }
    memory_free(moved);
}

void edit_shape_make(Editor *edit) {
    Vec2 ends[2], by = vec2_sub(edit->now.at, edit->grip.at), from[2], to[2];
    Points before = points_before(edit, ends);
    size_t first = edit->grip.index, count = edit->grip.grip == GRIP_POINT ? 1 : 2;
    for (size_t i = 0; i < count; i++) {
        Vec2 goal = count == 1 ? edit->now.at : vec2_add(before.at[first + i], by);
        from[i] = before.at[first + i];
        to[i] = vec2(snap_tidy(goal.x), snap_tidy(goal.y));
    }
    Shift shift = {from, to, count};
    for (size_t w = 0; edit->grip.list == DRAFT_WALLS && w < edit->plan_before.wall_count; w++)
        if (!edit->pointer.free || strcmp(edit->plan_before.walls[w].id, edit->dragged_id) == 0)
            shift_wall(edit, &edit->plan_before, w, &shift);
    if (edit->grip.list == DRAFT_WALLS)
        return;
    Vec2 *moved = memory_zeroed(before.count, sizeof *moved);
    for (size_t i = 0; i < before.count; i++)
        moved[i] = i >= first && i < first + count ? to[i - first] : before.at[i];
    if (edit->grip.list == DRAFT_EXITS) {
        draft_set_point(edit->draft, edit->dragged_id, "from", moved[0]);
        draft_set_point(edit->draft, edit->dragged_id, "to", moved[1]);
    } else {
        const char *member = edit->grip.list == DRAFT_ROOMS ? "outline" : "via";
        draft_set_points(edit->draft, edit->dragged_id, member, moved, before.count);
    }
    memory_free(moved);
}

/* The whole selection --------------------------------------------------------------------------------------------- */

/* Returns the corners of all selected walls and their targets; release both with memory_free. */
static Shift shift_of_selected(Editor *edit, const Plan *plan, Vec2 by) {
    size_t most = 0, count = 0;
    for (size_t w = 0; w < plan->wall_count; w++)
        most += edit_select_has(edit, plan->walls[w].id) ? plan->walls[w].points.count : 0;
    Shift shift = {memory_zeroed(most, sizeof(Vec2)), memory_zeroed(most, sizeof(Vec2)), most};
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t i = 0; edit_select_has(edit, plan->walls[w].id) && i < plan->walls[w].points.count; i++) {
            Vec2 to = vec2_add(plan->walls[w].points.at[i], by);
            shift.from[count] = plan->walls[w].points.at[i];
            shift.to[count++] = vec2(snap_tidy(to.x), snap_tidy(to.y));
        }
    return shift;
}

/* Slides the selected doors along their walls, unless the walls move too. */
static void slide_doors(Editor *edit, const Plan *plan, Vec2 by) {
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        const Wall *wall = &plan->walls[door->wall_index];
        if (!edit_select_has(edit, door->id) || edit_select_has(edit, wall->id))
            continue;
        const Vec2 *ends = wall->points.at + door->segment;
        double along = vec2_dot(by, vec2_unit(vec2_sub(ends[1], ends[0])));
        draft_set_number(edit->draft, door->id, "at", snap_tidy(door->at + along));
    }
}

/* Returns a place moved by a vector, without the rounding digits of the addition. */
static json_t *tidy_place(const json_t *place, Vec2 by) {
    return json_pack("[o, o]", json_number(snap_tidy(json_number_value(json_array_get(place, 0)) + by.x)),
                     json_number(snap_tidy(json_number_value(json_array_get(place, 1)) + by.y)));
}

/* Moves each place of an element that is neither a wall nor a door. */
static void move_element(Editor *edit, const char *id, Vec2 by) {
    static const char *const members[] = {"centre", "from", "to", "at", "outline", "area", "via"};
    for (size_t m = 0; m < sizeof members / sizeof *members; m++) {
        const json_t *value = json_object_get(draft_element(edit->draft, id), members[m]);
        if (!json_is_array(value) || !json_array_size(value))
            continue;
        json_t *moved = json_is_number(json_array_get(value, 0)) ? tidy_place(value, by) : json_array();
        for (size_t i = 0; i < json_array_size(value) && json_is_array(json_array_get(value, i)); i++)
            json_array_append_new(moved, tidy_place(json_array_get(value, i), by));
        draft_set(edit->draft, id, members[m], moved);
    }
}

void edit_shape_move(Editor *edit, const Plan *plan, Vec2 by) {
    size_t index;
    Shift shift = shift_of_selected(edit, plan, by);
    for (size_t w = 0; shift.count && w < plan->wall_count; w++)
        if (!edit->pointer.free || edit_select_has(edit, plan->walls[w].id))
            shift_wall(edit, plan, w, &shift);
    memory_free(shift.from);
    memory_free(shift.to);
    slide_doors(edit, plan, by);
    for (size_t i = 0; i < edit->id_count; i++) {
        DraftList list = draft_find(edit->draft, edit->ids[i], &index);
        if (list != DRAFT_WALLS && list != DRAFT_DOORS)
            move_element(edit, edit->ids[i], by);
    }
}
