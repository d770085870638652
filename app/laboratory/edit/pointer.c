/* The hand and the keys: which of them begins, follows and ends what. */

#include "laboratory/house/session_parts.h"

static const double STIR = 0.4; /* 1, of the reach: a hand that moves less has not moved */

static bool is_chain(EditTool tool) {
    return tool == TOOL_WALL || tool == TOOL_EXIT || tool == TOOL_MEASURE || tool == TOOL_AREA || tool == TOOL_ROUTE;
}

static void begin(HouseSession *live, bool keys) {
    if (live->edit.tool == TOOL_IMAGE)
        edit_image_begin(live, keys);
    else if (is_chain(live->edit.tool))
        edit_chain_begin(live, keys);
    else
        edit_place_begin(live, keys);
}

static bool can_begin(const HouseSession *live) {
    if (live->edit.tool == TOOL_IMAGE)
        return draft_plan(live->draft)->background.image;
    if (live->edit.tool == TOOL_DOOR)
        return draft_plan(live->draft)->wall_count;
    return live->edit.tool != TOOL_ROUTE || edit_way_person(live);
}

/* What is drawn so far stays drawn. */
void edit_pointer_take(HouseSession *live, EditTool tool) {
    if (live->edit.gesture && live->edit.gesture->escape)
        live->edit.gesture->escape(live);
    edit_gesture_drop(live);
    live->edit.pending = PENDING_NOTHING;
    live->edit.down = false;
    live->edit.handle = -1;
    live->edit.tool = tool < EDIT_TOOLS ? tool : TOOL_SELECT;
}

/* The hand -------------------------------------------------------------------------------------------------------- */

static void keep_hand(HouseSession *live, const Pointer *hand) {
    Editor *edit = &live->edit;
    edit->hand = *hand;
    edit->seen = true;
    if (edit->clicked && vec2_distance(hand->at, edit->keys_at) > STIR * hand->reach)
        edit->keys = edit->clicked = false;
}

/* Of the handle that is now where the button went down: what was there then may be gone. */
static void begin_handle(HouseSession *live, EditHold how) {
    Pointer was = live->edit.hand;
    EditHandle handle;
    was.at = live->edit.pressed;
    edit_select_meet(live);
    if (edit_handle_at(live, &was, &handle))
        edit_drag_begin(live, &handle, how);
}

/* The button is down and the hand has left the place: what was meant begins. */
static void begin_pending(HouseSession *live) {
    Editor *edit = &live->edit;
    EditPending pending = edit->pending;
    edit->pending = PENDING_NOTHING;
    if (pending == PENDING_HANDLE)
        begin_handle(live, HOLD_DRAG);
    else if (pending == PENDING_WHOLE)
        edit_drag_whole(live);
    else if (pending == PENDING_BOX)
        edit_drag_box(live);
}

void edit_pointer_point(HouseSession *live, const Pointer *hand) {
    Editor *edit = &live->edit;
    keep_hand(live, hand);
    if (edit->down && !edit->moved && vec2_distance(hand->at, edit->pressed) > STIR * hand->reach) {
        edit->moved = true;
        begin_pending(live);
    }
    edit_gesture_follow(live);
}

static bool is_room(const HouseSession *live, const char *id) {
    size_t index;
    return draft_find(live->draft, id, &index) == DRAFT_ROOMS;
}

static void press_select(HouseSession *live) {
    Editor *edit = &live->edit;
    EditHandle handle;
    edit->pending = PENDING_BOX;
    if (!edit->hand.more && edit_handle_at(live, &edit->hand, &handle)) {
        edit->pending = PENDING_HANDLE;
        return;
    }
    const char *id = edit_select_at(live, edit->hand.at);
    if (!id || is_room(live, id))
        return; /* a room is selected when the button is up, unless a rectangle is drawn */
    edit->pending = PENDING_NOTHING;
    if (edit->hand.more) {
        edit_select_toggle(live, id);
        return;
    }
    if (!edit_select_has(live, id))
        edit_select_only(live, id);
    edit->pending = PENDING_WHOLE;
}

void edit_pointer_press(HouseSession *live, const Pointer *hand, bool twice) {
    Editor *edit = &live->edit;
    edit_select_meet(live);
    keep_hand(live, hand);
    edit->down = true;
    edit->moved = false;
    edit->pressed = hand->at;
    edit->pending = PENDING_NOTHING;
    edit->keys = edit->clicked = false; /* what was begun by keys goes on by hand */
    if (edit->gesture && twice && edit->tool == TOOL_MEASURE && edit_measure_side(live)) {
        edit_gesture_drop(live);
    } else if (edit->gesture) {
        edit_gesture_follow(live);
        edit->gesture->put(live, false);
    } else if (edit->tool == TOOL_SELECT) {
        press_select(live);
    } else if (can_begin(live) && !(edit->tool == TOOL_EXIT && edit_way_across(live))) {
        begin(live, false);
        if (edit->gesture && (is_chain(edit->tool) || edit->tool == TOOL_IMAGE))
            edit->gesture->put(live, false);
    }
}

/* A click on a handle takes it up; one beside everything selects the room, or nothing. */
static void release_pending(HouseSession *live) {
    Editor *edit = &live->edit;
    EditPending pending = edit->pending;
    edit->pending = PENDING_NOTHING;
    if (pending == PENDING_HANDLE) {
        begin_handle(live, HOLD_CLICK);
    } else if (pending == PENDING_BOX) {
        const char *id = edit_select_at(live, edit->hand.at);
        if (edit->hand.more && id)
            edit_select_toggle(live, id);
        else if (!edit->hand.more)
            edit_select_only(live, id);
    }
}

void edit_pointer_release(HouseSession *live, const Pointer *hand) {
    Editor *edit = &live->edit;
    if (!edit->down)
        return;
    edit_pointer_point(live, hand);
    if (edit->gesture && edit->gesture->release)
        edit->gesture->release(live, edit->moved);
    else if (!edit->gesture && !edit->moved)
        release_pending(live);
    edit->down = false;
    edit->pending = PENDING_NOTHING;
}

/* Keys ------------------------------------------------------------------------------------------------------------ */

/* Takes up the handle that has the focus of the keys. */
static bool take_focused(HouseSession *live) {
    EditHandle handles[EDIT_HANDLES];
    edit_select_meet(live);
    size_t count = edit_handle_list(live, draft_plan(live->draft), handles);
    int handle = live->edit.handle;
    if (live->edit.tool != TOOL_SELECT || handle < 0 || (size_t)handle >= count)
        return false;
    edit_drag_begin(live, &handles[handle], HOLD_KEYS);
    return true;
}

bool edit_pointer_type(HouseSession *live, const char *letters) {
    if (!live->edit.gesture && !(edit_field_begins(letters) && take_focused(live)))
        return false;
    return edit_field_type(live, letters);
}

bool edit_pointer_enter(HouseSession *live) {
    Editor *edit = &live->edit;
    if (edit->gesture) {
        if (!*edit->wrong)
            edit->gesture->put(live, true);
        return true;
    }
    if (edit->tool == TOOL_SELECT)
        return take_focused(live);
    if (can_begin(live))
        begin(live, true);
    return true;
}

bool edit_pointer_back(HouseSession *live) {
    const EditGesture *gesture = live->edit.gesture;
    if (!gesture)
        return false;
    if (edit_field_back(live))
        return true;
    if (gesture->back)
        gesture->back(live);
    return true;
}

bool edit_pointer_escape(HouseSession *live) {
    Editor *edit = &live->edit;
    if (*edit->typed) {
        edit->fields[edit->field].typed = false;
        *edit->typed = *edit->wrong = 0;
        edit_gesture_follow(live);
    } else if (edit->gesture && edit->gesture->escape) {
        edit->gesture->escape(live);
    } else if (edit->gesture) {
        edit_gesture_drop(live);
    } else if (edit->tool != TOOL_SELECT) {
        edit_pointer_take(live, TOOL_SELECT);
    } else if (edit->handle >= 0) {
        edit->handle = -1;
    } else if (edit->id_count) {
        edit_select_only(live, NULL);
    } else {
        return false;
    }
    return true;
}
