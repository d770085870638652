/* Places one item at the pointer: a door, a piece of furniture, a person. */
#include <stdio.h>

#include "laboratory/edit/editor_state.h"

typedef struct PlaceKind {
    const char *name; /* name of the undo step */
    const char *fields[EDIT_FIELDS], *units[EDIT_FIELDS];
    size_t field_count, first; /* first: the first field used while the pointer gives the place */
    const EditGesture *gesture;
} PlaceKind;

static const EditGesture door, piece, person;

static const PlaceKind kinds[EDIT_TOOLS] = {
    [TOOL_DOOR] = {"Place door", {"x", "y", "width", "at"}, {"m", "m", "m", "m"}, 4, 2, &door},
    [TOOL_FURNITURE] =
        {"Place furniture", {"x", "y", "angle", "width", "depth"}, {"m", "m", "degree", "m", "m"}, 5, 2, &piece},
    [TOOL_PERSON] = {"Place person", {"x", "y", "heading"}, {"m", "m", "degree"}, 3, 2, &person},
};

/* Writes the name of the step: "Place wardrobe". */
static void name_step(Editor *edit, const PlaceKind *kind, char name[EDIT_NAME]) {
    size_t count, item = edit->items[edit->tool];
    const CatalogueRow *items = edit_items_list(edit, &count);
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
    if (edit->tool == TOOL_FURNITURE && edit->items[TOOL_FURNITURE] == 0 && !keys) {
        edit->sizing = true;
        edit->field = 3;
        edit->now.corner = edit_gesture_snap(edit, (SnapAsk){.along = NAN, .faces = true});
    }
    edit_gesture_follow(edit);
}

static bool put(Editor *edit, bool keys) {
    if (edit->refusal && (keys || !edit->limited))
        return false;
    if (edit->tool == TOOL_DOOR)
        edit->door_width = edit->now.amount;
    *edit->made = 0;
    if (!edit_gesture_end(edit))
        return false;
    if (*edit->made)
        edit_select_only(edit, edit->made);
    return true;
}

/* Ends the placement. An item that is dropped at an invalid place is not placed; a rectangle whose drawing has only
 * begun continues. */
static void release(Editor *edit, bool moved) {
    if (edit->sizing && !moved)
        edit->taken = true;
    else if (!put(edit, false))
        edit->taken = true; /* the gesture continues, with the reason, until another press */
}

static void say(Editor *edit, Text *words) {
    const EditTarget *now = &edit->now;
    if (edit->tool == TOOL_DOOR && now->wall < edit->begun.wall_count)
        text_format(words, "door %.2f m wide in wall %s, %.2f m from its beginning", now->amount,
                    edit->begun.walls[now->wall].id, now->along);
    else if (edit->tool == TOOL_FURNITURE)
        text_format(words, "%.2f x %.2f m, %g degrees, at x %.2f, y %.2f m", now->size.x, now->size.y, now->angle,
                    now->at.x, now->at.y);
    else
        text_format(words, "at x %.2f, y %.2f m, heading %g degrees", now->at.x, now->at.y, now->angle);
    text_add(words, edit->keys ? ": Enter puts it there, Tab goes to the next number" : "");
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
        edit_marks_line(edit, edit->now.at, vec2_along(edit->now.at, 0.5, snap_heading(edit->now.angle)));
    }
}

#define PLACE(follow_, make_, limit_)                                                                                  \
    { .follow = follow_, .make = make_, .limit = limit_, .put = put, .release = release, .say = say, .show = show }
static const EditGesture door = PLACE(edit_door_follow, edit_door_make, edit_door_limit),
                         piece = PLACE(edit_piece_follow, edit_piece_make, NULL),
                         person = PLACE(edit_person_follow, edit_person_make, NULL);
