#include "laboratory/edit/drag.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan/overlap.h"
#include "laboratory/edit/door.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/handle.h"
#include "laboratory/edit/marks.h"
#include "laboratory/edit/select.h"
#include "laboratory/edit/shape.h"

static const double LEAST_SIZE = 0.01; /* m, of a piece whose corner is dragged */

static const EditGesture shape, body, slide, whole, box;

/* Furniture and people --------------------------------------------------------------------------------------------- */

static const Furniture *dragged_piece(const Editor *edit) {
    const Plan *plan = &edit->plan_before;
    for (size_t i = 0; i < plan->furniture_count; i++)
        if (strcmp(plan->furniture[i].id, edit->dragged_id) == 0)
            return &plan->furniture[i];
    return NULL;
}

static const Person *dragged_person(const Editor *edit) {
    size_t person = plan_find_person(&edit->plan_before, edit->dragged_id);
    return person == SIZE_MAX ? NULL : &edit->plan_before.people[person];
}

static void show_place(Editor *edit) {
    edit_field_typed(edit, 0, &edit->now.at.x);
    edit_field_typed(edit, 1, &edit->now.at.y);
    edit_field_show(edit, 0, edit->now.at.x);
    edit_field_show(edit, 1, edit->now.at.y);
}

static void update_middle(Editor *edit, const Furniture *piece) {
    const char *without[] = {edit->dragged_id};
    SnapAsk ask = {.at = vec2_add(edit->pointer.at, edit->offset),
                   .reach = edit->pointer.reach,
                   .free = edit->pointer.free,
                   .along = NAN,
                   .without = without,
                   .without_count = 1,
                   .names = edit_select_snap_name};
    Vec2 from = edit->grip.at;
    if (edit->pointer.straight && fabs(ask.at.x - from.x) >= fabs(ask.at.y - from.y))
        ask.at.y = from.y;
    else if (edit->pointer.straight)
        ask.at.x = from.x;
    if (!edit->keys)
        edit->snap = piece ? snap_piece_place(&edit->plan_before, piece, &ask) : snap_point(&edit->plan_before, &ask);
    edit->now.at = edit->keys ? from : edit->snap.at;
    show_place(edit);
}

/* Resizes a piece by its corner; the opposite corner stays in place. */
static void update_corner(Editor *edit, const Furniture *piece) {
    static const Vec2 signs[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    Vec2 sign = signs[edit->grip.index], axis = snap_heading(piece->angle);
    const char *without[] = {edit->dragged_id};
    Vec2 corner =
        edit->keys
            ? edit->grip.at
            : edit_gesture_snap(edit, (SnapAsk){.along = NAN, .faces = true, .without = without, .without_count = 1});
    Vec2 half = vec2(sign.x * piece->size.x / 2, sign.y * piece->size.y / 2);
    Vec2 fixed = vec2_sub(piece->centre, vec2_turn(half, axis)), own = vec2_unturn(vec2_sub(corner, fixed), axis);
    double width = fmax(own.x * sign.x, LEAST_SIZE), depth = fmax(own.y * sign.y, LEAST_SIZE);
    edit_field_typed(edit, 0, &width);
    edit_field_typed(edit, 1, &depth);
    edit_field_show(edit, 0, width);
    edit_field_show(edit, 1, depth);
    edit->now.size = vec2(snap_tidy(width), snap_tidy(depth));
    Vec2 centre = vec2_add(fixed, vec2_turn(vec2(sign.x * width / 2, sign.y * depth / 2), axis));
    edit->now.at = vec2(snap_tidy(centre.x), snap_tidy(centre.y));
}

static void update_turn(Editor *edit, Vec2 centre, double angle, double ahead) {
    Vec2 to = vec2_sub(vec2_add(edit->pointer.at, edit->offset), centre);
    if (!edit->keys && vec2_length(to) > 0)
        angle = snap_turn(snap_angle(to) + ahead, edit->pointer.free);
    edit_field_typed(edit, 0, &angle);
    edit_field_show(edit, 0, angle);
    edit->now.angle = angle;
}

static void update_body(Editor *edit) {
    const Furniture *piece = dragged_piece(edit);
    const Person *person = dragged_person(edit);
    if (edit->grip.grip == GRIP_MIDDLE)
        update_middle(edit, piece);
    else if (edit->grip.grip == GRIP_CORNER && piece)
        update_corner(edit, piece);
    else if (piece)
        update_turn(edit, piece->centre, piece->angle, 90);
    else if (person)
        update_turn(edit, person->at, person->heading, 0);
}

static void make_body(Editor *edit) {
    bool piece = edit->grip.list == DRAFT_FURNITURE;
    if (edit->grip.grip == GRIP_TURN) {
        draft_set_number(edit->draft, edit->dragged_id, piece ? "angle" : "heading", edit->now.angle);
        return;
    }
    draft_set_point(edit->draft, edit->dragged_id, piece ? "centre" : "at", edit->now.at);
    if (edit->grip.grip == GRIP_CORNER)
        draft_set_point(edit->draft, edit->dragged_id, "size", edit->now.size);
}

/* Handles --------------------------------------------------------------------------------------------------------- */

static void set_dragged(Editor *edit, const EditHandle *handle) {
    Text copy = {0};
    text_add(&copy, handle->id);
    memory_free(edit->dragged_id);
    edit->dragged_id = copy.text;
    edit->grip = *handle;
    edit->grip.id = edit->dragged_id;
}

static void name_step(const Editor *edit, const EditHandle *handle, char name[EDIT_NAME]) {
    static const char *const steps[] = {[GRIP_POINT] = "Move a point of %.100s",
                                        [GRIP_SEGMENT] = "Move a segment of %.100s",
                                        [GRIP_EDGE] = "Change the width of %.100s",
                                        [GRIP_CORNER] = "Resize %.100s",
                                        [GRIP_TURN] = "Turn %.100s",
                                        [GRIP_MIDDLE] = "Move %.100s",
                                        [GRIP_WHOLE] = "Move %.100s"};
    char item[EDIT_NAME];
    edit_select_name_at(edit, draft_plan(edit->draft), handle->id, &handle->at, item);
    bool end = handle->grip == GRIP_POINT && handle->list == DRAFT_EXITS;
    snprintf(name, EDIT_NAME, end ? "Move an end of %.100s" : steps[handle->grip], item);
}

static void list_fields(Editor *edit, const EditHandle *handle) {
    static const char *const place[] = {"x", "y"}, *const metres[] = {"m", "m", "m", "m"};
    static const char *const point[] = {"length", "angle", "x", "y"}, *const point_units[] = {"m", "degree", "m", "m"};
    static const char *const door[] = {"at", "width"}, *const size[] = {"width", "depth"};
    static const char *const angle[] = {"angle"}, *const degree[] = {"degree"};
    if (handle->grip == GRIP_TURN)
        edit_field_list(edit, angle, degree, 1);
    else if (handle->grip == GRIP_CORNER)
        edit_field_list(edit, size, metres, 2);
    else if (handle->list == DRAFT_DOORS)
        edit_field_list(edit, door, metres, 2);
    else if (handle->grip == GRIP_POINT && handle->list != DRAFT_ROUTES)
        edit_field_list(edit, point, point_units, 4);
    else
        edit_field_list(edit, place, metres, 2);
    if (handle->grip == GRIP_EDGE)
        edit->field = 1;
}

static const EditGesture *gesture_of(const EditHandle *handle) {
    if (handle->list == DRAFT_DOORS)
        return &slide;
    if (handle->list == DRAFT_FURNITURE || handle->list == DRAFT_PEOPLE)
        return &body;
    return &shape;
}

void edit_drag_begin(Editor *edit, const EditHandle *handle, EditGrab how) {
    char name[EDIT_NAME], *id = text_copy(handle->id);
    EditHandle copy = *handle;
    copy.id = id;
    edit_gesture_cancel(edit);
    name_step(edit, &copy, name);
    set_dragged(edit, &copy);
    edit_gesture_begin(edit, gesture_of(&edit->grip), name, how != GRAB_DRAG);
    edit->offset = vec2_sub(copy.at, how == GRAB_KEYS ? edit->pointer.at : edit->pressed);
    edit->grabbed = how != GRAB_DRAG;
    edit->clicked = how == GRAB_CLICK;
    list_fields(edit, &edit->grip);
    edit_gesture_update(edit);
    memory_free(id);
}

static bool confirm(Editor *edit, bool keys) {
    if (edit->refusal && keys && !edit->limited)
        return false;
    if (!edit_gesture_end_valid(edit)) {
        edit_gesture_cancel(edit);
        return false;
    }
    return true;
}

/* Ends the drag, unless the press was a click: a click grabs the handle, and the next click drops it. */
static void release(Editor *edit, bool moved) {
    if (moved || edit->grabbed)
        confirm(edit, false);
    else
        edit->grabbed = true;
}

/* Finds the wall that the dragged piece overlaps, and the depth, m; false: none. */
static bool find_overlap(const Editor *edit, const Plan *plan, size_t *wall, double *depth) {
    size_t index;
    if (draft_find(edit->draft, edit->dragged_id, &index) != DRAFT_FURNITURE || index >= plan->furniture_count)
        return false;
    *depth = overlap_depth(plan, &plan->furniture[index], wall);
    return *depth >= OVERLAP_LEAST;
}

/* Writes the fields as a list: "width 1.20 m, depth 0.60 m". */
static void list_values(const Editor *edit, Text *text) {
    text_add(text, "");
    for (size_t i = 0; i < edit->field_count; i++) {
        const EditField *field = &edit->fields[i];
        if (i)
            text_add(text, ", ");
        text_format(text, strcmp(field->unit, "degree") == 0 ? "%s %.1f degrees" : "%s %.2f m", field->name,
                    field->value);
    }
}

static void describe(Editor *edit, Text *text) {
    const Plan *plan = draft_plan(edit->draft);
    char item[EDIT_NAME];
    size_t wall = 0;
    double depth = 0;
    Text values = {0};
    edit_select_name_at(edit, &edit->plan_before, edit->dragged_id, &edit->grip.at, item);
    list_values(edit, &values);
    text_format(text, "%s: %s", item, values.text);
    if (find_overlap(edit, plan, &wall, &depth)) {
        edit_select_name_at(edit, plan, plan->walls[wall].id, &edit->now.at, item);
        text_format(text, "; it stands %.0f cm in the %s", 100 * depth, item);
    }
    memory_free(values.text);
}

static void show(Editor *edit) {
    edit_marks_dragged(edit);
}

#define DRAG(update_, make_, limit_)                                                                                   \
    {                                                                                                                  \
        .update = update_, .make = make_, .limit = limit_, .confirm = confirm, .release = release,                     \
        .describe = describe, .show = show                                                                             \
    }
static const EditGesture shape = DRAG(edit_shape_update, edit_shape_make, NULL),
                         body = DRAG(update_body, make_body, NULL),
                         slide = DRAG(edit_door_slide_update, edit_door_slide_make, edit_door_slide_limit);

/* The whole selection --------------------------------------------------------------------------------------------- */

static void update_whole(Editor *edit) {
    Vec2 by = vec2_sub(edit->pointer.at, edit->pressed);
    if (edit->pointer.straight && fabs(by.x) >= fabs(by.y))
        by.y = 0;
    else if (edit->pointer.straight)
        by.x = 0;
    double grid = edit->pointer.free ? SNAP_FREE_GRID : SNAP_GRID;
    edit->now.at = vec2(snap_tidy(round(by.x / grid) * grid), snap_tidy(round(by.y / grid) * grid));
    edit->snap = (Snap){.at = edit->pointer.at};
    edit_field_typed(edit, 0, &edit->now.at.x);
    edit_field_typed(edit, 1, &edit->now.at.y);
    edit_field_show(edit, 0, edit->now.at.x);
    edit_field_show(edit, 1, edit->now.at.y);
}

static void make_whole(Editor *edit) {
    edit_shape_move(edit, &edit->plan_before, edit->now.at);
}

static void describe_whole(Editor *edit, Text *text) {
    char items[EDIT_NAME];
    edit_select_names(edit, items);
    text_format(text, "%s is moved by %.2f m, %.2f m.", items, edit->now.at.x, edit->now.at.y);
}

static void show_whole(Editor *edit) {
    if (vec2_length(edit->now.at) > 0)
        edit_marks_length(edit, edit->pressed, vec2_add(edit->pressed, edit->now.at));
}

static const EditGesture whole = {.update = update_whole,
                                  .make = make_whole,
                                  .confirm = confirm,
                                  .release = release,
                                  .describe = describe_whole,
                                  .show = show_whole};

/* Returns the distance from the press position to a segment of a wall, m. */
static double distance_to_piece(const Editor *edit, const EditHandle *handle) {
    const Plan *plan = draft_plan(edit->draft);
    size_t w = 0;
    while (w < plan->wall_count && strcmp(plan->walls[w].id, handle->id) != 0)
        w++;
    if (w == plan->wall_count)
        return HUGE_VAL;
    const Vec2 *ends = plan->walls[w].points.at + handle->index;
    return vec2_distance(edit->pressed, vec2_nearest_on_segment(edit->pressed, ends[0], ends[1]));
}

void edit_drag_whole(Editor *edit) {
    static const char *const names[] = {"along x", "along y"}, *const units[] = {"m", "m"};
    char name[EDIT_NAME], items[EDIT_NAME];
    EditHandle handles[EDIT_HANDLES];
    size_t count = edit_handle_list(edit, draft_plan(edit->draft), handles);
    const EditHandle *meant = NULL; /* the middle, or the nearest segment of a wall: it snaps as its handle does */
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        double distance = handles[i].grip == GRIP_MIDDLE    ? 0
                          : handles[i].grip == GRIP_SEGMENT ? distance_to_piece(edit, &handles[i])
                                                            : HUGE_VAL;
        meant = distance < nearest ? &handles[i] : meant;
        nearest = fmin(nearest, distance);
    }
    if (meant) {
        edit_drag_begin(edit, meant, GRAB_DRAG);
        return;
    }
    edit_select_names(edit, items);
    snprintf(name, sizeof name, "Move %.100s", items);
    edit_gesture_begin(edit, &whole, name, false);
    edit_field_list(edit, names, units, 2);
    edit_gesture_update(edit);
}

/* The selection rectangle ----------------------------------------------------------------------------------------- */

static void update_box(Editor *edit) {
    edit->now.at = edit->pointer.at;
}

static bool confirm_box(Editor *edit, bool keys) {
    Box within = box_include(box_include(box_empty(), edit->pressed), edit->now.at);
    bool more = edit->pointer.more;
    (void)keys;
    edit_gesture_cancel(edit);
    edit_select_within(edit, within, more);
    return true;
}

static void release_box(Editor *edit, bool moved) {
    (void)moved;
    confirm_box(edit, false);
}

static void describe_box(Editor *edit, Text *text) {
    (void)edit;
    text_add(text, "Release the button to select the items inside.");
}

static void show_box(Editor *edit) {
    Vec2 a = edit->pressed, b = edit->now.at;
    edit_marks_outline(edit, (Vec2[]){a, vec2(b.x, a.y), b, vec2(a.x, b.y)}, 4);
}

static const EditGesture box = {
    .update = update_box, .confirm = confirm_box, .release = release_box, .describe = describe_box, .show = show_box};

void edit_drag_box(Editor *edit) {
    edit_gesture_begin(edit, &box, "", false);
    edit_gesture_update(edit);
}
