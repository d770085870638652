/* Moves, turns and resizes furniture and people. */
#include <math.h>
#include <string.h>

#include "laboratory/edit/editor_state.h"

static const double LEAST_SIZE = 0.01; /* m */

static const Furniture *held_piece(const Editor *edit) {
    const Plan *plan = &edit->begun;
    for (size_t i = 0; i < plan->furniture_count; i++)
        if (strcmp(plan->furniture[i].id, edit->held) == 0)
            return &plan->furniture[i];
    return NULL;
}

static const Person *held_person(const Editor *edit) {
    size_t person = plan_find_person(&edit->begun, edit->held);
    return person == SIZE_MAX ? NULL : &edit->begun.people[person];
}

static void show_place(Editor *edit) {
    edit_field_typed(edit, 0, &edit->now.at.x);
    edit_field_typed(edit, 1, &edit->now.at.y);
    edit_field_show(edit, 0, edit->now.at.x);
    edit_field_show(edit, 1, edit->now.at.y);
}

static void follow_middle(Editor *edit, const Furniture *piece) {
    const char *without[] = {edit->held};
    SnapAsk ask = {.at = vec2_add(edit->pointer.at, edit->offset),
                   .reach = edit->pointer.reach,
                   .free = edit->pointer.free,
                   .along = NAN,
                   .without = without,
                   .without_count = 1};
    Vec2 from = edit->grip.at;
    if (edit->pointer.straight && fabs(ask.at.x - from.x) >= fabs(ask.at.y - from.y))
        ask.at.y = from.y;
    else if (edit->pointer.straight)
        ask.at.x = from.x;
    if (!edit->keys)
        edit->snap = piece ? snap_piece_place(&edit->begun, piece, &ask) : snap_point(&edit->begun, &ask);
    edit->now.at = edit->keys ? from : edit->snap.at;
    show_place(edit);
}

/* Resizes a piece by its corner; the opposite corner stays in place. */
static void follow_corner(Editor *edit, const Furniture *piece) {
    static const Vec2 signs[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    Vec2 sign = signs[edit->grip.index], axis = snap_heading(piece->angle);
    const char *without[] = {edit->held};
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

static void follow_turn(Editor *edit, Vec2 centre, double angle, double ahead) {
    Vec2 to = vec2_sub(vec2_add(edit->pointer.at, edit->offset), centre);
    if (!edit->keys && vec2_length(to) > 0)
        angle = snap_turn(snap_angle(to) + ahead, edit->pointer.free);
    edit_field_typed(edit, 0, &angle);
    edit_field_show(edit, 0, angle);
    edit->now.angle = angle;
}

void edit_body_follow(Editor *edit) {
    const Furniture *piece = held_piece(edit);
    const Person *person = held_person(edit);
    if (edit->grip.grip == GRIP_MIDDLE)
        follow_middle(edit, piece);
    else if (edit->grip.grip == GRIP_CORNER && piece)
        follow_corner(edit, piece);
    else if (piece)
        follow_turn(edit, piece->centre, piece->angle, 90);
    else if (person)
        follow_turn(edit, person->at, person->heading, 0);
}

void edit_body_make(Editor *edit) {
    bool piece = edit->grip.list == DRAFT_FURNITURE;
    if (edit->grip.grip == GRIP_TURN) {
        draft_set_number(edit->draft, edit->held, piece ? "angle" : "heading", edit->now.angle);
        return;
    }
    draft_set_point(edit->draft, edit->held, piece ? "centre" : "at", edit->now.at);
    if (edit->grip.grip == GRIP_CORNER)
        draft_set_point(edit->draft, edit->held, "size", edit->now.size);
}
