/* Places people. */
#include <math.h>
#include <stdio.h>

#include "laboratory/edit/editor_state.h"

enum { FIELD_X, FIELD_Y, FIELD_HEADING };

/* Turns the placed person to the pointer while the button is down, once the pointer is far enough away. */
static void turn_to_pointer(Editor *edit) {
    Vec2 to = vec2_sub(edit->pointer.at, edit->now.at);
    if (edit->down && edit->moved && vec2_length(to) > edit->pointer.reach)
        edit->now.angle = snap_turn(snap_angle(to), edit->pointer.free);
}

void edit_person_follow(Editor *edit) {
    EditTarget *now = &edit->now;
    if (!edit->down)
        now->at = edit_gesture_snap(edit, (SnapAsk){.along = NAN});
    else
        now->at = vec2(snap_tidy(round(edit->pressed.x / SNAP_GRID) * SNAP_GRID),
                       snap_tidy(round(edit->pressed.y / SNAP_GRID) * SNAP_GRID));
    edit_field_typed(edit, FIELD_X, &now->at.x);
    edit_field_typed(edit, FIELD_Y, &now->at.y);
    turn_to_pointer(edit);
    edit_field_typed(edit, FIELD_HEADING, &now->angle);
    edit_field_show(edit, FIELD_X, now->at.x);
    edit_field_show(edit, FIELD_Y, now->at.y);
    edit_field_show(edit, FIELD_HEADING, now->angle);
}

void edit_person_make(Editor *edit) {
    const EditTarget *now = &edit->now;
    edit_items_stock(edit);
    size_t item = edit->items[TOOL_PERSON];
    const char *profile = item < edit->profile_count ? edit->profiles[item] : "adult";
    json_t *element = json_pack("{s:s, s:[o, o], s:o}", "profile", profile, "at", json_number(now->at.x),
                                json_number(now->at.y), "heading", json_number(now->angle));
    snprintf(edit->made, EDIT_NAME, "%s", draft_add(edit->draft, DRAFT_PEOPLE, element));
}
