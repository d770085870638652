#include "laboratory/edit/place.h"

#include <math.h>
#include <stdio.h>

#include "laboratory/edit/body.h"
#include "laboratory/edit/door.h"
#include "laboratory/edit/exit.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/marks.h"
#include "laboratory/edit/select.h"
#include "laboratory/edit/tool_items.h"

static const double LEAST_SIZE = 0.01; /* m */
static const double ON_OPENING = 1e-6; /* m: rounding of the middle of an opening */

/* The fields of each kind of item begin with its place. */
enum { FIELD_X, FIELD_Y };
enum { PIECE_ANGLE = 2, PIECE_WIDTH, PIECE_DEPTH };
enum { PERSON_HEADING = 2 };

/* Furniture -------------------------------------------------------------------------------------------------------- */

/* Returns the chosen piece; NULL: a rectangle is drawn. */
static const CatalogueItem *chosen_piece(Editor *edit) {
    size_t item = edit->chosen_rows[TOOL_FURNITURE];
    edit_tool_items_stock(edit);
    return item > 0 && item <= edit->catalogue.count ? &edit->catalogue.items[item - 1] : NULL;
}

static SnapAsk ask_of(const Editor *edit) {
    const Pointer *pointer = &edit->pointer;
    return (SnapAsk){.at = pointer->at,
                     .reach = pointer->reach,
                     .free = pointer->free,
                     .along = NAN,
                     .names = edit_select_snap_name};
}

/* Makes a rectangle from its first corner to the pointer, or as typed. */
static void update_rectangle(Editor *edit) {
    EditTarget *now = &edit->now;
    Vec2 to = edit_gesture_snap(edit, (SnapAsk){.along = NAN, .faces = true});
    Vec2 size = vec2_sub(to, now->corner);
    double width = fabs(size.x), depth = fabs(size.y);
    edit_field_typed(edit, PIECE_WIDTH, &width);
    edit_field_typed(edit, PIECE_DEPTH, &depth);
    now->size = vec2(snap_tidy(fmax(width, LEAST_SIZE)), snap_tidy(fmax(depth, LEAST_SIZE)));
    now->at = vec2(snap_tidy(now->corner.x + copysign(now->size.x, size.x) / 2),
                   snap_tidy(now->corner.y + copysign(now->size.y, size.y) / 2));
}

/* Places a piece at the pointer: with its back to a wall, or next to other furniture. */
static void update_piece(Editor *edit) {
    EditTarget *now = &edit->now;
    const CatalogueItem *item = chosen_piece(edit);
    Furniture piece = {.size = item ? item->size : vec2(1, 0.5), .topples = TOPPLE_NO};
    edit_field_typed(edit, PIECE_WIDTH, &piece.size.x);
    edit_field_typed(edit, PIECE_DEPTH, &piece.size.y);
    bool turned = edit_field_typed(edit, PIECE_ANGLE, &piece.angle);
    SnapAsk ask = ask_of(edit);
    double angle = piece.angle;
    Vec2 at = ask.at;
    if (!turned && !edit->keys && snap_piece_back(&edit->plan_before, &piece, &ask, &angle, &at)) {
        piece.angle = angle;
        ask.at = at;
    }
    if (!edit->keys)
        edit->snap = snap_piece_place(&edit->plan_before, &piece, &ask);
    now->at = edit->keys ? ask.at : edit->snap.at;
    now->angle = piece.angle;
    now->size = piece.size;
}

static void update_furniture(Editor *edit) {
    EditTarget *now = &edit->now;
    if (edit->sizing)
        update_rectangle(edit);
    else
        update_piece(edit);
    edit_field_typed(edit, FIELD_X, &now->at.x);
    edit_field_typed(edit, FIELD_Y, &now->at.y);
    edit_field_typed(edit, PIECE_ANGLE, &now->angle);
    const double values[] = {now->at.x, now->at.y, now->angle, now->size.x, now->size.y};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        edit_field_show(edit, i, values[i]);
}

static void make_furniture(Editor *edit) {
    static const char *const faces[] = {"front", "back", "left", "right", "no"};
    const EditTarget *now = &edit->now;
    const CatalogueItem *item = chosen_piece(edit);
    json_t *element =
        json_pack("{s:[o, o], s:[o, o], s:o}", "centre", json_number(now->at.x), json_number(now->at.y), "size",
                  json_number(now->size.x), json_number(now->size.y), "angle", json_number(now->angle));
    if (item) {
        json_object_set_new(element, "name", json_string(item->name));
        json_object_set_new(element, "height", json_number(item->height));
        json_object_set_new(element, "topples", json_string(faces[item->topples]));
        json_object_set_new(element, "probability", json_number(item->probability));
    }
    snprintf(edit->added_id, EDIT_NAME, "%s", draft_add(edit->draft, DRAFT_FURNITURE, element));
}

/* People ----------------------------------------------------------------------------------------------------------- */

/* Turns the placed person to the pointer while the button is down, once the pointer is far enough away. */
static void turn_to_pointer(Editor *edit) {
    Vec2 to = vec2_sub(edit->pointer.at, edit->now.at);
    if (edit->down && edit->moved && vec2_length(to) > edit->pointer.reach)
        edit->now.angle = snap_turn(snap_angle(to), edit->pointer.free);
}

static void update_person(Editor *edit) {
    EditTarget *now = &edit->now;
    if (!edit->down)
        now->at = edit_gesture_snap(edit, (SnapAsk){.along = NAN});
    else
        now->at = vec2(snap_tidy(round(edit->pressed.x / SNAP_GRID) * SNAP_GRID),
                       snap_tidy(round(edit->pressed.y / SNAP_GRID) * SNAP_GRID));
    edit_field_typed(edit, FIELD_X, &now->at.x);
    edit_field_typed(edit, FIELD_Y, &now->at.y);
    turn_to_pointer(edit);
    edit_field_typed(edit, PERSON_HEADING, &now->angle);
    edit_field_show(edit, FIELD_X, now->at.x);
    edit_field_show(edit, FIELD_Y, now->at.y);
    edit_field_show(edit, PERSON_HEADING, now->angle);
}

static void make_person(Editor *edit) {
    const EditTarget *now = &edit->now;
    edit_tool_items_stock(edit);
    size_t item = edit->chosen_rows[TOOL_PERSON];
    const char *profile = item < edit->profile_count ? edit->profiles[item] : "adult";
    json_t *element = json_pack("{s:s, s:[o, o], s:o}", "profile", profile, "at", json_number(now->at.x),
                                json_number(now->at.y), "heading", json_number(now->angle));
    snprintf(edit->added_id, EDIT_NAME, "%s", draft_add(edit->draft, DRAFT_PEOPLE, element));
}

/* The gesture ------------------------------------------------------------------------------------------------------ */

typedef struct PlaceKind {
    const char *name; /* name of the undo step */
    const char *fields[EDIT_FIELDS], *units[EDIT_FIELDS];
    size_t field_count, first; /* first: the first field used while the pointer gives the place */
    const EditGesture *gesture;
} PlaceKind;

static const EditGesture door, piece, person, leave;

static const PlaceKind kinds[EDIT_TOOLS] = {
    [TOOL_DOOR] = {"Place door", {"x", "y", "width", "at"}, {"m", "m", "m", "m"}, 4, 2, &door},
    [TOOL_FURNITURE] =
        {"Place furniture", {"x", "y", "angle", "width", "depth"}, {"m", "m", "degree", "m", "m"}, 5, 2, &piece},
    [TOOL_EXIT] = {"Place exit", {"x", "y", "width"}, {"m", "m", "m"}, 3, 2, &leave},
    [TOOL_PERSON] = {"Place person", {"x", "y", "heading"}, {"m", "m", "degree"}, 3, 2, &person},
};

/* Writes the name of the step: "Place wardrobe". */
static void name_step(Editor *edit, const PlaceKind *kind, char name[EDIT_NAME]) {
    size_t count, item = edit->chosen_rows[edit->tool];
    const CatalogueRow *items = edit_tool_items_list(edit, &count);
    snprintf(name, EDIT_NAME, "%s", kind->name);
    if (edit->tool == TOOL_FURNITURE && item < count)
        snprintf(name, EDIT_NAME, "Place %.60s", items[item].name);
}

void edit_place_begin(Editor *edit, bool keys) {
    const PlaceKind *kind = &kinds[edit->tool];
    char name[EDIT_NAME];
    name_step(edit, kind, name);
    edit_gesture_begin(edit, kind->gesture, name, keys);
    edit->now.amount = edit->door_width;
    edit->now.corner = edit->pointer.at;
    edit_field_list(edit, kind->fields, kind->units, kind->field_count);
    edit->field = keys ? 0 : kind->first;
    if (edit->tool == TOOL_FURNITURE && edit->chosen_rows[TOOL_FURNITURE] == 0 && !keys) {
        edit->sizing = true;
        edit->field = 3;
        edit->now.corner = edit_gesture_snap(edit, (SnapAsk){.along = NAN, .faces = true});
    }
    edit_gesture_update(edit);
}

static bool confirm(Editor *edit, bool keys) {
    if (edit->refusal && (keys || !edit->limited))
        return false;
    if (edit->tool == TOOL_DOOR)
        edit->door_width = edit->now.amount;
    *edit->added_id = 0;
    if (!edit_gesture_end(edit))
        return false;
    if (*edit->added_id)
        edit_select_only(edit, edit->added_id);
    edit->placed = true;
    edit->placed_at = edit->pointer.at;
    const Plan *plan = draft_plan(edit->draft);
    if (edit->cures && edit->tool == TOOL_EXIT && !plan->person_count && !plan->crowd_count)
        edit->tool = TOOL_PERSON;
    return true;
}

void edit_place_cure(Editor *edit) {
    edit->cures = true;
    Pointer pointer = edit->pointer;
    if (edit->tool != TOOL_EXIT || !edit_exit_only(edit, &edit->pointer.at))
        return;
    edit->pointer.reach = ON_OPENING;
    edit_place_begin(edit, false);
    if (!confirm(edit, false))
        edit_gesture_cancel(edit);
    edit->pointer = pointer;
}

/* Ends the placement of an exit; where none can lie, nothing happens. */
static void release_exit(Editor *edit, bool moved) {
    (void)moved;
    if (!confirm(edit, false))
        edit_gesture_cancel(edit);
}

/* Ends the placement. An item that is dropped at an invalid place is not placed; a rectangle whose drawing has only
 * begun continues. */
static void release(Editor *edit, bool moved) {
    if (edit->sizing && !moved)
        edit->grabbed = true;
    else if (!confirm(edit, false))
        edit->grabbed = true; /* the gesture continues, with the reason, until another press */
}

static void describe(Editor *edit, Text *text) {
    const EditTarget *now = &edit->now;
    if (edit->tool == TOOL_DOOR && now->wall < edit->plan_before.wall_count)
        text_format(text, "Door: %.2f m wide, in wall %s, %.2f m from its start.", now->amount,
                    edit->plan_before.walls[now->wall].id, now->along);
    else if (edit->tool == TOOL_FURNITURE)
        text_format(text, "Furniture: %.2f x %.2f m, %g degrees, at x %.2f m, y %.2f m.", now->size.x, now->size.y,
                    now->angle, now->at.x, now->at.y);
    else
        text_format(text, "Person: at x %.2f m, y %.2f m, heading %g degrees.", now->at.x, now->at.y, now->angle);
    if (edit->keys)
        text_add(text, " Press Enter to place it, or Tab for the next number.");
}

static void show(Editor *edit) {
    const Plan *plan = draft_plan(edit->draft);
    if (!edit->has_good)
        return;
    if (edit->tool == TOOL_DOOR && plan->door_count) {
        edit_marks_door(edit, plan, &plan->doors[plan->door_count - 1]);
    } else if (edit->tool == TOOL_FURNITURE && plan->furniture_count) {
        edit_marks_piece(edit, &plan->furniture[plan->furniture_count - 1]);
    } else if (edit->tool == TOOL_PERSON) {
        Vec2 outline[BODY_POINTS];
        size_t count = edit_body_outline(edit, edit->now.at, edit->now.angle, outline);
        edit_marks_outline(edit, outline, count);
        edit_marks_line(edit, edit->now.at, vec2_along(edit->now.at, 0.5, snap_heading(edit->now.angle)));
    }
}

static void describe_exit(Editor *edit, Text *text) {
    edit_exit_describe(edit, text);
}

/* Promises ----------------------------------------------------------------------------------------------------------
 */

static void promise_door(const Editor *edit, Text *text) {
    text_format(text, "door %.2f m", edit->now.amount);
}

static void promise_furniture(const Editor *edit, Text *text) {
    size_t item = edit->chosen_rows[TOOL_FURNITURE];
    if (item > 0 && item <= edit->catalogue.count)
        text_format(text, "%s %.2f x %.2f m", edit->catalogue.items[item - 1].name, edit->now.size.x, edit->now.size.y);
}

static void promise_person(const Editor *edit, Text *text) {
    (void)edit;
    text_add(text, "person here, drag to turn");
}

static const char *warn_person(Editor *edit) {
    return edit_body_touches(edit, draft_plan(edit->draft), edit->now.at, edit->now.angle, edit->touched)
               ? edit->touched
               : NULL;
}

#define PLACE(update_, make_, ...)                                                                                     \
    {                                                                                                                  \
        .update = update_, .make = make_, .confirm = confirm, .release = release, .describe = describe, .show = show,  \
        __VA_ARGS__                                                                                                    \
    }
static const EditGesture door =
    PLACE(edit_door_update, edit_door_make, .limit = edit_door_limit, .promise = promise_door);
static const EditGesture piece = PLACE(update_furniture, make_furniture, .promise = promise_furniture);
static const EditGesture person = PLACE(update_person, make_person, .promise = promise_person, .warn = warn_person);
static const EditGesture leave = {.update = edit_exit_update,
                                  .refuse = edit_exit_refuse,
                                  .make = edit_exit_make,
                                  .limit = edit_exit_limit,
                                  .confirm = confirm,
                                  .release = release_exit,
                                  .describe = describe_exit,
                                  .promise = edit_exit_promise,
                                  .show = edit_exit_show};
