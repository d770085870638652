/* What all gestures have in common: a step that is made anew with each movement, tried, and put down or let go. */
#include <stdio.h>

#include "laboratory/house/session_parts.h"

static void forget_refusal(Editor *edit) {
    memory_free(edit->refusal);
    edit->refusal = NULL;
}

static void keep_refusal(Editor *edit, const Fault *fault) {
    Text text = {0};
    forget_refusal(edit);
    text_add(&text, fault->count ? fault->lines[0] : "it cannot be so");
    edit->refusal = text.text;
}

static void keep_begun(HouseSession *live) {
    Fault none = {0};
    plan_read_text(&live->edit.begun, "", draft_text(live->draft), NULL, 0, &none);
    fault_clear(&none);
}

void edit_gesture_open(HouseSession *live, const char *name) {
    edit_gesture_drop(live);
    draft_begin(live->draft, name);
}

bool edit_gesture_close(HouseSession *live, Fault *fault) {
    if (!draft_end(live->draft, fault))
        return false;
    edit_select_known(live);
    house_follow_edited(live);
    return true;
}

void edit_gesture_begin(HouseSession *live, const EditGesture *gesture, const char *name, bool keys) {
    Editor *edit = &live->edit;
    edit_gesture_drop(live);
    edit->gesture = gesture;
    edit->keys = keys;
    edit->keys_at = edit->hand.at;
    edit->now = edit->good = (EditTarget){.at = edit->hand.at};
    edit->has_good = edit->limited = false;
    snprintf(edit->name, sizeof edit->name, "%s", name);
    keep_begun(live);
    if (gesture->make)
        draft_begin(live->draft, name);
}

/* Makes the target in the draft and tries it. */
static bool try_now(HouseSession *live, Fault *fault) {
    uint64_t before = draft_revision(live->draft);
    draft_rewind(live->draft);
    live->edit.gesture->make(live);
    if (!draft_try(live->draft, fault))
        return false;
    if (draft_revision(live->draft) != before)
        house_follow_edited(live);
    live->edit.good = live->edit.now;
    live->edit.has_good = true;
    return true;
}

void edit_gesture_follow(HouseSession *live) {
    Editor *edit = &live->edit;
    Fault fault = {0}, again = {0};
    if (!edit->gesture)
        return;
    if (edit->gesture->make && !draft_is_open(live->draft)) { /* a number was set meanwhile: a step of its own */
        keep_begun(live);
        draft_begin(live->draft, edit->name);
    }
    edit->snap = (Snap){.at = edit->hand.at};
    edit->limited = false;
    edit->gesture->follow(live);
    forget_refusal(edit);
    if (edit->gesture->make && !try_now(live, &fault)) {
        keep_refusal(edit, &fault);
        if (edit->gesture->limit && edit->gesture->limit(live))
            edit->limited = try_now(live, &again);
    }
    fault_clear(&fault);
    fault_clear(&again);
}

/* Nothing is in the hand any more. */
static void empty_hand(HouseSession *live) {
    Editor *edit = &live->edit;
    edit->gesture = NULL;
    edit->taken = edit->sizing = edit->keys = edit->clicked = false;
    edit->offset = vec2(0, 0);
    edit->snap = (Snap){.guide_count = 0};
    edit_field_list(live, NULL, NULL, 0);
    edit_chain_clear(live);
    forget_refusal(edit);
    memory_free(edit->held);
    edit->held = NULL;
    plan_free(&edit->begun);
}

void edit_gesture_drop(HouseSession *live) {
    if (!live->edit.gesture)
        return;
    bool made = live->edit.gesture->make;
    uint64_t before = draft_revision(live->draft);
    empty_hand(live);
    if (made)
        draft_cancel(live->draft);
    edit_select_known(live);
    if (draft_revision(live->draft) != before)
        house_follow_edited(live);
}

bool edit_gesture_end(HouseSession *live) {
    Editor *edit = &live->edit;
    Fault fault = {0};
    draft_begin(live->draft, edit->name);
    edit->gesture->make(live);
    bool good = draft_end(live->draft, &fault);
    if (good) {
        empty_hand(live);
        edit_select_known(live);
    } else {
        keep_refusal(edit, &fault);
        draft_begin(live->draft, edit->name);
    }
    house_follow_edited(live);
    fault_clear(&fault);
    return good;
}

bool edit_gesture_settle(HouseSession *live) {
    Editor *edit = &live->edit;
    if (!edit->has_good) {
        return false;
    }
    edit->now = edit->good;
    return edit_gesture_end(live);
}

Vec2 edit_gesture_snap(HouseSession *live, SnapAsk ask) {
    Editor *edit = &live->edit;
    ask.at = vec2_add(edit->hand.at, edit->offset);
    ask.reach = edit->hand.reach;
    ask.free = edit->hand.free;
    ask.straight = edit->hand.straight;
    edit->snap = snap_point(edit->gesture ? &edit->begun : draft_plan(live->draft), &ask);
    return edit->snap.at;
}
