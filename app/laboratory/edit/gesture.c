#include "laboratory/edit/gesture.h"

#include <stdio.h>

#include "laboratory/edit/field.h"
#include "laboratory/edit/select.h"

static void forget_refusal(Editor *edit) {
    memory_free(edit->refusal);
    edit->refusal = NULL;
}

static void store_refusal(Editor *edit, const Fault *fault) {
    forget_refusal(edit);
    edit->refusal = edit_select_named(edit, fault->count ? fault->lines[0] : "this edit is not possible");
}

static void store_plan_before(Editor *edit) {
    Fault none = {0};
    plan_read_text(&edit->plan_before, "", draft_text(edit->draft), NULL, 0, &none);
    fault_clear(&none);
}

void edit_gesture_begin_step(Editor *edit, const char *name) {
    edit_gesture_cancel(edit);
    draft_begin(edit->draft, name);
}

bool edit_gesture_end_step(Editor *edit, Fault *fault) {
    Fault own = {0};
    bool good = draft_end(edit->draft, &own);
    for (size_t i = 0; i < own.count; i++) {
        char *named = edit_select_named(edit, own.lines[i]);
        fault_add(fault, "%s", named);
        memory_free(named);
    }
    fault_clear(&own);
    if (!good)
        return false;
    edit_select_prune(edit);
    edit->changed = true;
    return true;
}

void edit_gesture_begin(Editor *edit, const EditGesture *gesture, const char *name, bool keys) {
    edit_gesture_cancel(edit);
    edit->gesture = gesture;
    edit->keys = keys;
    edit->keys_at = edit->pointer.at;
    edit->now = edit->good = (EditTarget){.at = edit->pointer.at};
    edit->has_good = edit->limited = false;
    snprintf(edit->name, sizeof edit->name, "%s", name);
    store_plan_before(edit);
    if (gesture->make)
        draft_begin(edit->draft, name);
}

/* Applies the target to the draft and tries the result. */
static bool try_now(Editor *edit, Fault *fault) {
    uint64_t before = draft_revision(edit->draft);
    draft_rewind(edit->draft);
    edit->gesture->make(edit);
    if (!draft_try(edit->draft, fault))
        return false;
    if (draft_revision(edit->draft) != before)
        edit->changed = true;
    edit->good = edit->now;
    edit->has_good = true;
    return true;
}

/* Takes the item out of the draft again. */
static void put_back(Editor *edit) {
    Fault none = {0};
    draft_rewind(edit->draft);
    if (edit->has_good && draft_try(edit->draft, &none))
        edit->changed = true;
    edit->has_good = false;
    fault_clear(&none);
}

void edit_gesture_update(Editor *edit) {
    Fault fault = {0}, again = {0};
    if (!edit->gesture)
        return;
    if (edit->gesture->make && !draft_is_open(edit->draft)) { /* a number was set meanwhile, as its own step */
        store_plan_before(edit);
        draft_begin(edit->draft, edit->name);
    }
    edit->snap = (Snap){.at = edit->pointer.at};
    edit->limited = false;
    edit->gesture->update(edit);
    forget_refusal(edit);
    const char *reason = edit->gesture->refuse ? edit->gesture->refuse(edit) : NULL;
    if (reason) {
        edit->refusal = text_copy(reason);
        put_back(edit);
    } else if (edit->gesture->make && !try_now(edit, &fault)) {
        store_refusal(edit, &fault);
        if (edit->gesture->limit && edit->gesture->limit(edit))
            edit->limited = try_now(edit, &again);
    }
    fault_clear(&fault);
    fault_clear(&again);
}

/* Forgets the gesture. */
static void forget_gesture(Editor *edit) {
    if (edit->gesture->end)
        edit->gesture->end(edit);
    edit->gesture = NULL;
    edit->grabbed = edit->sizing = edit->keys = edit->clicked = false;
    edit->offset = vec2(0, 0);
    edit->snap = (Snap){.guide_count = 0};
    edit_field_list(edit, NULL, NULL, 0);
    forget_refusal(edit);
    memory_free(edit->dragged_id);
    edit->dragged_id = NULL;
    plan_free(&edit->plan_before);
}

void edit_gesture_cancel(Editor *edit) {
    if (!edit->gesture)
        return;
    bool changes_draft = edit->gesture->make;
    uint64_t before = draft_revision(edit->draft);
    forget_gesture(edit);
    if (changes_draft)
        draft_cancel(edit->draft);
    edit_select_prune(edit);
    if (draft_revision(edit->draft) != before)
        edit->changed = true;
}

bool edit_gesture_end(Editor *edit) {
    Fault fault = {0};
    draft_begin(edit->draft, edit->name);
    edit->gesture->make(edit);
    bool good = draft_end(edit->draft, &fault);
    if (good) {
        forget_gesture(edit);
        edit_select_prune(edit);
    } else {
        store_refusal(edit, &fault);
        draft_begin(edit->draft, edit->name);
    }
    edit->changed = true;
    fault_clear(&fault);
    return good;
}

bool edit_gesture_end_valid(Editor *edit) {
    if (!edit->has_good) {
        return false;
    }
    edit->now = edit->good;
    return edit_gesture_end(edit);
}

Vec2 edit_gesture_snap(Editor *edit, SnapAsk ask) {
    ask.at = vec2_add(edit->pointer.at, edit->offset);
    ask.reach = edit->pointer.reach;
    ask.free = edit->pointer.free;
    ask.straight = edit->pointer.straight;
    ask.names = edit_select_snap_name;
    edit->snap = snap_point(edit->gesture ? &edit->plan_before : draft_plan(edit->draft), &ask);
    return edit->snap.at;
}
