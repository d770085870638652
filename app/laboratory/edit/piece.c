/* Places furniture. */
#include <math.h>
#include <stdio.h>

#include "laboratory/edit/editor_state.h"

static const double LEAST_SIZE = 0.01; /* m */

enum { FIELD_X, FIELD_Y, FIELD_ANGLE, FIELD_WIDTH, FIELD_DEPTH };

/* Returns the chosen piece; NULL: a rectangle is drawn. */
static const CatalogueItem *chosen(Editor *edit) {
    size_t item = edit->items[TOOL_FURNITURE];
    edit_items_stock(edit);
    return item > 0 && item <= edit->catalogue.count ? &edit->catalogue.items[item - 1] : NULL;
}

static SnapAsk ask_of(const Editor *edit) {
    const Pointer *pointer = &edit->pointer;
    return (SnapAsk){.at = pointer->at, .reach = pointer->reach, .free = pointer->free, .along = NAN};
}

/* Makes a rectangle from its first corner to the pointer, or as typed. */
static void follow_rectangle(Editor *edit) {
    EditTarget *now = &edit->now;
    Vec2 to = edit_gesture_snap(edit, (SnapAsk){.along = NAN, .faces = true});
    Vec2 size = vec2_sub(to, now->corner);
    double width = fabs(size.x), depth = fabs(size.y);
    edit_field_typed(edit, FIELD_WIDTH, &width);
    edit_field_typed(edit, FIELD_DEPTH, &depth);
    now->size = vec2(snap_tidy(fmax(width, LEAST_SIZE)), snap_tidy(fmax(depth, LEAST_SIZE)));
    now->at = vec2(snap_tidy(now->corner.x + copysign(now->size.x, size.x) / 2),
                   snap_tidy(now->corner.y + copysign(now->size.y, size.y) / 2));
}

/* Places a piece at the pointer: with its back to a wall, or next to other furniture. */
static void follow_piece(Editor *edit) {
    EditTarget *now = &edit->now;
    const CatalogueItem *item = chosen(edit);
    Furniture piece = {.size = item ? item->size : vec2(1, 0.5), .topples = TOPPLE_NO};
    edit_field_typed(edit, FIELD_WIDTH, &piece.size.x);
    edit_field_typed(edit, FIELD_DEPTH, &piece.size.y);
    bool turned = edit_field_typed(edit, FIELD_ANGLE, &piece.angle);
    SnapAsk ask = ask_of(edit);
    double angle = piece.angle;
    Vec2 at = ask.at;
    if (!turned && !edit->keys && snap_piece_back(&edit->begun, &piece, &ask, &angle, &at)) {
        piece.angle = angle;
        ask.at = at;
    }
    if (!edit->keys)
        edit->snap = snap_piece_place(&edit->begun, &piece, &ask);
    now->at = edit->keys ? ask.at : edit->snap.at;
    now->angle = piece.angle;
    now->size = piece.size;
}

void edit_piece_follow(Editor *edit) {
    EditTarget *now = &edit->now;
    if (edit->sizing)
        follow_rectangle(edit);
    else
        follow_piece(edit);
    edit_field_typed(edit, FIELD_X, &now->at.x);
    edit_field_typed(edit, FIELD_Y, &now->at.y);
    edit_field_typed(edit, FIELD_ANGLE, &now->angle);
    const double values[] = {now->at.x, now->at.y, now->angle, now->size.x, now->size.y};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        edit_field_show(edit, i, values[i]);
}

void edit_piece_make(Editor *edit) {
    static const char *const faces[] = {"front", "back", "left", "right", "no"};
    const EditTarget *now = &edit->now;
    const CatalogueItem *item = chosen(edit);
    json_t *element =
        json_pack("{s:[o, o], s:[o, o], s:o}", "centre", json_number(now->at.x), json_number(now->at.y), "size",
                  json_number(now->size.x), json_number(now->size.y), "angle", json_number(now->angle));
    if (item) {
        json_object_set_new(element, "name", json_string(item->name));
        json_object_set_new(element, "height", json_number(item->height));
        json_object_set_new(element, "topples", json_string(faces[item->topples]));
        json_object_set_new(element, "probability", json_number(item->probability));
    }
    snprintf(edit->made, EDIT_NAME, "%s", draft_add(edit->draft, DRAFT_FURNITURE, element));
}
