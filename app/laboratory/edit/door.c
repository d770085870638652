#include "laboratory/edit/door.h"

#include <stdio.h>
#include <string.h>

#include "laboratory/edit/field.h"
#include "laboratory/edit/select.h"

static const double LEAST_WIDTH = 0.10; /* m, least width of a door whose edge is dragged */

/* Kinds of doors to choose from. */
static const char *const door_kinds[] = {"hinged", "opening", "sliding"};

/* The fields of a new door. */
enum { FIELD_X, FIELD_Y, FIELD_WIDTH, FIELD_AT };

static double to_grid(const Editor *edit, double along) {
    double grid = edit->pointer.free ? SNAP_FREE_GRID : SNAP_GRID;
    return snap_tidy(round(along / grid) * grid);
}

static Vec2 place_on_wall(const Editor *edit) {
    const EditTarget *now = &edit->now;
    const Vec2 *ends = edit->plan_before.walls[now->wall].points.at + now->segment;
    return vec2_along(ends[0], now->along, vec2_unit(vec2_sub(ends[1], ends[0])));
}

/* Tells the wall that the door snaps to: "on wall between bedroom and corridor". */
static void tell_wall(Editor *edit, const char *where) {
    char name[SNAP_NAME];
    const Plan *plan = &edit->plan_before;
    edit_select_snap_name(plan, plan->walls[edit->now.wall].id, place_on_wall(edit), name);
    snprintf(edit->snap.text, SNAP_TEXT, "%s %s", where, name);
}

/* Finds the place on a wall that is nearest to a point. False: there is no wall. */
static bool find_wall(Editor *edit, Vec2 at) {
    EditTarget *now = &edit->now;
    SnapWall wall;
    now->wall = SIZE_MAX;
    if (!snap_wall(&edit->plan_before, at, &wall))
        return false;
    now->wall = wall.wall;
    now->segment = wall.segment;
    now->along = to_grid(edit, wall.along);
    tell_wall(edit, "on");
    return true;
}

/* Snaps a door to the middle of a segment, as to the ends of a wall. */
static void snap_middle(Editor *edit) {
    const Vec2 *ends = edit->plan_before.walls[edit->now.wall].points.at + edit->now.segment;
    double middle = vec2_distance(ends[0], ends[1]) / 2;
    if (edit->pointer.free || fabs(edit->now.along - middle) > edit->pointer.reach)
        return;
    edit->now.along = snap_tidy(middle);
    tell_wall(edit, "middle of");
}

void edit_door_update(Editor *edit) {
    Vec2 at = edit->pointer.at;
    bool placed = edit_field_typed(edit, FIELD_X, &at.x);
    placed |= edit_field_typed(edit, FIELD_Y, &at.y);
    edit_field_show(edit, FIELD_X, at.x);
    edit_field_show(edit, FIELD_Y, at.y);
    edit_field_typed(edit, FIELD_WIDTH, &edit->now.amount);
    edit_field_show(edit, FIELD_WIDTH, edit->now.amount);
    if (!find_wall(edit, at))
        return;
    if (!placed)
        snap_middle(edit);
    edit_field_typed(edit, FIELD_AT, &edit->now.along);
    edit_field_show(edit, FIELD_AT, edit->now.along);
    edit->now.at = edit->snap.at = place_on_wall(edit);
}

void edit_door_make(Editor *edit) {
    const EditTarget *now = &edit->now;
    const char *kind = door_kinds[edit->chosen_rows[TOOL_DOOR]];
    const char *wall = now->wall < edit->plan_before.wall_count ? edit->plan_before.walls[now->wall].id : "";
    json_t *element = json_pack("{s:s, s:I, s:o, s:o, s:s}", "wall", wall, "segment", (json_int_t)now->segment, "at",
                                json_number(now->along), "width", json_number(now->amount), "kind", kind);
    snprintf(edit->added_id, EDIT_NAME, "%s", draft_add(edit->draft, DRAFT_DOORS, element));
}

/* Moves a door into its segment and clear of the other doors. False: it needs no move, or there is no space for it. */
static bool limit_to_segment(Editor *edit, const char *self) {
    EditTarget *now = &edit->now;
    if (now->wall >= edit->plan_before.wall_count)
        return false;
    const Vec2 *ends = edit->plan_before.walls[now->wall].points.at + now->segment;
    double low = now->amount / 2, high = vec2_distance(ends[0], ends[1]) - now->amount / 2, before = now->along;
    for (size_t d = 0; d < edit->plan_before.door_count; d++) {
        const Door *other = &edit->plan_before.doors[d];
        if (other->wall_index != now->wall || (size_t)other->segment != now->segment || strcmp(other->id, self) == 0)
            continue;
        double away = (other->width + now->amount) / 2;
        if (other->at <= before)
            low = fmax(low, other->at + away);
        else
            high = fmin(high, other->at - away);
    }
    if (low > high)
        return false;
    now->along = snap_tidy(real_clamp(now->along, low, high));
    now->at = edit->snap.at = place_on_wall(edit);
    return now->along != before;
}

/* Limits the door's place, unless the place is typed: typed values are taken literally. */
bool edit_door_limit(Editor *edit) {
    double typed;
    bool placed = edit_field_typed(edit, FIELD_X, &typed) || edit_field_typed(edit, FIELD_Y, &typed) ||
                  edit_field_typed(edit, FIELD_AT, &typed);
    return !placed && limit_to_segment(edit, "");
}

/* Sliding --------------------------------------------------------------------------------------------------------- */

enum { SLIDE_AT, SLIDE_WIDTH };

static const Door *dragged_door(const Editor *edit) {
    const Plan *plan = &edit->plan_before;
    for (size_t d = 0; d < plan->door_count; d++)
        if (strcmp(plan->doors[d].id, edit->dragged_id) == 0)
            return &plan->doors[d];
    return NULL;
}

/* Returns the pointer's place along the door's own segment, m. */
static double pointer_along(const Editor *edit, const Door *door) {
    const Vec2 *ends = edit->plan_before.walls[door->wall_index].points.at + door->segment;
    Vec2 pointer = vec2_add(edit->pointer.at, edit->offset);
    return vec2_dot(vec2_sub(pointer, ends[0]), vec2_unit(vec2_sub(ends[1], ends[0])));
}

/* Moves one edge of the door to the pointer; the other edge stays in place. */
static void update_edge(Editor *edit, const Door *door) {
    bool last = edit->grip.index == 1;
    double fixed = door->at + (last ? -0.5 : 0.5) * door->width, edge = to_grid(edit, pointer_along(edit, door));
    double width = fmax(last ? edge - fixed : fixed - edge, LEAST_WIDTH);
    if (edit->keys)
        width = door->width;
    edit_field_typed(edit, SLIDE_WIDTH, &width);
    edit->now.amount = snap_tidy(width);
    edit->now.along = snap_tidy(fixed + (last ? 0.5 : -0.5) * width);
}

void edit_door_slide_update(Editor *edit) {
    const Door *door = dragged_door(edit);
    edit->now.wall = door->wall_index;
    edit->now.segment = (size_t)door->segment;
    edit->now.amount = door->width;
    edit->now.along = door->at;
    if (edit->grip.grip == GRIP_EDGE) {
        update_edge(edit, door);
    } else if (!edit->keys) {
        find_wall(edit, vec2_add(edit->pointer.at, edit->offset));
        snap_middle(edit);
    }
    edit_field_typed(edit, SLIDE_AT, &edit->now.along);
    edit_field_typed(edit, SLIDE_WIDTH, &edit->now.amount);
    edit_field_show(edit, SLIDE_AT, edit->now.along);
    edit_field_show(edit, SLIDE_WIDTH, edit->now.amount);
    edit->now.at = edit->snap.at = place_on_wall(edit);
}

void edit_door_slide_make(Editor *edit) {
    const EditTarget *now = &edit->now;
    draft_set_text(edit->draft, edit->dragged_id, "wall", edit->plan_before.walls[now->wall].id);
    draft_set(edit->draft, edit->dragged_id, "segment", json_integer((json_int_t)now->segment));
    draft_set_number(edit->draft, edit->dragged_id, "at", now->along);
    draft_set_number(edit->draft, edit->dragged_id, "width", now->amount);
}

bool edit_door_slide_limit(Editor *edit) {
    return edit->grip.grip != GRIP_EDGE && !edit_field_any(edit) && limit_to_segment(edit, edit->dragged_id);
}
