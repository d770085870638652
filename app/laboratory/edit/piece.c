/* Furniture that is placed. */
#include <math.h>
#include <stdio.h>

#include "laboratory/house/session_parts.h"

static const double LEAST_SIZE = 0.01; /* m */

enum { FIELD_X, FIELD_Y, FIELD_ANGLE, FIELD_WIDTH, FIELD_DEPTH };

/* The chosen piece; NULL: a rectangle as it is drawn. */
static const CatalogueItem *chosen(HouseSession *live) {
    size_t item = live->edit.items[TOOL_FURNITURE];
    edit_items_stock(live);
    return item > 0 && item <= live->edit.catalogue.count ? &live->edit.catalogue.items[item - 1] : NULL;
}

static SnapAsk ask_of(const HouseSession *live) {
    const Pointer *hand = &live->edit.hand;
    return (SnapAsk){.at = hand->at, .reach = hand->reach, .free = hand->free, .along = NAN};
}

/* A rectangle from where it began to the hand, or as it is typed. */
static void follow_rectangle(HouseSession *live) {
    Editor *edit = &live->edit;
    EditTarget *now = &edit->now;
    Vec2 to = edit_gesture_snap(live, (SnapAsk){.along = NAN, .faces = true});
    Vec2 size = vec2_sub(to, now->corner);
    double width = fabs(size.x), depth = fabs(size.y);
    edit_field_typed(live, FIELD_WIDTH, &width);
    edit_field_typed(live, FIELD_DEPTH, &depth);
    now->size = vec2(snap_tidy(fmax(width, LEAST_SIZE)), snap_tidy(fmax(depth, LEAST_SIZE)));
    now->at = vec2(snap_tidy(now->corner.x + copysign(now->size.x, size.x) / 2),
                   snap_tidy(now->corner.y + copysign(now->size.y, size.y) / 2));
}

/* A piece at the hand: with its back to a wall, or beside what is there. */
static void follow_piece(HouseSession *live) {
    Editor *edit = &live->edit;
    EditTarget *now = &edit->now;
    const CatalogueItem *item = chosen(live);
    Furniture piece = {.size = item ? item->size : vec2(1, 0.5), .topples = TOPPLE_NO};
    edit_field_typed(live, FIELD_WIDTH, &piece.size.x);
    edit_field_typed(live, FIELD_DEPTH, &piece.size.y);
    bool turned = edit_field_typed(live, FIELD_ANGLE, &piece.angle);
    SnapAsk ask = ask_of(live);
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

void edit_piece_follow(HouseSession *live) {
    Editor *edit = &live->edit;
    EditTarget *now = &edit->now;
    if (edit->sizing)
        follow_rectangle(live);
    else
        follow_piece(live);
    edit_field_typed(live, FIELD_X, &now->at.x);
    edit_field_typed(live, FIELD_Y, &now->at.y);
    edit_field_typed(live, FIELD_ANGLE, &now->angle);
    const double values[] = {now->at.x, now->at.y, now->angle, now->size.x, now->size.y};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        edit_field_show(live, i, values[i]);
}

void edit_piece_make(HouseSession *live) {
    static const char *const faces[] = {"front", "back", "left", "right", "no"};
    const EditTarget *now = &live->edit.now;
    const CatalogueItem *item = chosen(live);
    json_t *element =
        json_pack("{s:[o, o], s:[o, o], s:o}", "centre", json_number(now->at.x), json_number(now->at.y), "size",
                  json_number(now->size.x), json_number(now->size.y), "angle", json_number(now->angle));
    if (item) {
        json_object_set_new(element, "name", json_string(item->name));
        json_object_set_new(element, "height", json_number(item->height));
        json_object_set_new(element, "topples", json_string(faces[item->topples]));
        json_object_set_new(element, "probability", json_number(item->probability));
    }
    snprintf(live->edit.made, EDIT_NAME, "%s", draft_add(live->draft, DRAFT_FURNITURE, element));
}
