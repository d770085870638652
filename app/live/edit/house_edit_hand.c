/* The hand and the keys: which of them begins, follows and ends what. */

#include "live/house/house_live_parts.h"

static const double STIR = 0.4; /* 1, of the reach: a hand that moves less has not moved */

static bool is_chain(LiveTool tool) {
    return tool == TOOL_WALL || tool == TOOL_EXIT || tool == TOOL_MEASURE || tool == TOOL_AREA || tool == TOOL_ROUTE;
}

static void begin(HouseLive *live, bool keys) {
    if (live->edit.tool == TOOL_IMAGE)
        house_edit_image_begin(live, keys);
    else if (is_chain(live->edit.tool))
        house_edit_chain_begin(live, keys);
    else
        house_edit_place_begin(live, keys);
}

static bool can_begin(const HouseLive *live) {
    if (live->edit.tool == TOOL_IMAGE)
        return draft_plan(live->draft)->background.image;
    if (live->edit.tool == TOOL_DOOR)
        return draft_plan(live->draft)->wall_count;
    return live->edit.tool != TOOL_ROUTE || house_edit_way_person(live);
}

/* What is drawn so far stays drawn. */
void house_edit_hand_take(HouseLive *live, LiveTool tool) {
    if (live->edit.gesture && live->edit.gesture->escape)
        live->edit.gesture->escape(live);
    house_edit_gesture_drop(live);
    live->edit.pending = PENDING_NOTHING;
    live->edit.down = false;
    live->edit.handle = -1;
    live->edit.tool = tool < LIVE_TOOLS ? tool : TOOL_SELECT;
}

/* The hand -------------------------------------------------------------------------------------------------------- */

static void keep_hand(HouseLive *live, const LiveHand *hand) {
    HouseEdit *edit = &live->edit;
    edit->hand = *hand;
    edit->seen = true;
    if (edit->clicked && vec2_distance(hand->at, edit->keys_at) > STIR * hand->reach)
        edit->keys = edit->clicked = false;
}

/* Of the handle that is now where the button went down: what was there then may be gone. */
static void begin_handle(HouseLive *live, EditHold how) {
    LiveHand was = live->edit.hand;
    EditHandle handle;
    was.at = live->edit.pressed;
    house_edit_select_meet(live);
    if (house_edit_handle_at(live, &was, &handle))
        house_edit_drag_begin(live, &handle, how);
}

/* The button is down and the hand has left the place: what was meant begins. */
static void begin_pending(HouseLive *live) {
    HouseEdit *edit = &live->edit;
    EditPending pending = edit->pending;
    edit->pending = PENDING_NOTHING;
    if (pending == PENDING_HANDLE)
        begin_handle(live, HOLD_DRAG);
    else if (pending == PENDING_WHOLE)
        house_edit_drag_whole(live);
    else if (pending == PENDING_BOX)
        house_edit_drag_box(live);
}

void house_edit_hand_point(HouseLive *live, const LiveHand *hand) {
    HouseEdit *edit = &live->edit;
    keep_hand(live, hand);
    if (edit->down && !edit->moved && vec2_distance(hand->at, edit->pressed) > STIR * hand->reach) {
        edit->moved = true;
        begin_pending(live);
    }
    house_edit_gesture_follow(live);
}

static bool is_room(const HouseLive *live, const char *id) {
    size_t index;
    return draft_find(live->draft, id, &index) == DRAFT_ROOMS;
}

static void press_select(HouseLive *live) {
    HouseEdit *edit = &live->edit;
    EditHandle handle;
    edit->pending = PENDING_BOX;
    if (!edit->hand.more && house_edit_handle_at(live, &edit->hand, &handle)) {
        edit->pending = PENDING_HANDLE;
        return;
    }
    const char *id = house_edit_select_at(live, edit->hand.at);
    if (!id || is_room(live, id))
        return; /* a room is selected when the button is up, unless a rectangle is drawn */
    edit->pending = PENDING_NOTHING;
    if (edit->hand.more) {
        house_edit_select_toggle(live, id);
        return;
    }
    if (!house_edit_select_has(live, id))
        house_edit_select_only(live, id);
    edit->pending = PENDING_WHOLE;
}

void house_edit_hand_press(HouseLive *live, const LiveHand *hand, bool twice) {
    HouseEdit *edit = &live->edit;
    house_edit_select_meet(live);
    keep_hand(live, hand);
    edit->down = true;
    edit->moved = false;
    edit->pressed = hand->at;
    edit->pending = PENDING_NOTHING;
    edit->keys = edit->clicked = false; /* what was begun by keys goes on by hand */
    if (edit->gesture && twice && edit->tool == TOOL_MEASURE && house_edit_measure_side(live)) {
        house_edit_gesture_drop(live);
    } else if (edit->gesture) {
        house_edit_gesture_follow(live);
        edit->gesture->put(live, false);
    } else if (edit->tool == TOOL_SELECT) {
        press_select(live);
    } else if (can_begin(live) && !(edit->tool == TOOL_EXIT && house_edit_way_across(live))) {
        begin(live, false);
        if (edit->gesture && (is_chain(edit->tool) || edit->tool == TOOL_IMAGE))
            edit->gesture->put(live, false);
    }
}

/* A click on a handle takes it up; one beside everything selects the room, or nothing. */
static void release_pending(HouseLive *live) {
    HouseEdit *edit = &live->edit;
    EditPending pending = edit->pending;
    edit->pending = PENDING_NOTHING;
    if (pending == PENDING_HANDLE) {
        begin_handle(live, HOLD_CLICK);
    } else if (pending == PENDING_BOX) {
        const char *id = house_edit_select_at(live, edit->hand.at);
        if (edit->hand.more && id)
            house_edit_select_toggle(live, id);
        else if (!edit->hand.more)
            house_edit_select_only(live, id);
    }
}

void house_edit_hand_release(HouseLive *live, const LiveHand *hand) {
    HouseEdit *edit = &live->edit;
    if (!edit->down)
        return;
    house_edit_hand_point(live, hand);
    if (edit->gesture && edit->gesture->release)
        edit->gesture->release(live, edit->moved);
    else if (!edit->gesture && !edit->moved)
        release_pending(live);
    edit->down = false;
    edit->pending = PENDING_NOTHING;
}

/* Keys ------------------------------------------------------------------------------------------------------------ */

/* Takes up the handle that has the focus of the keys. */
static bool take_focused(HouseLive *live) {
    EditHandle handles[EDIT_HANDLES];
    house_edit_select_meet(live);
    size_t count = house_edit_handle_list(live, draft_plan(live->draft), handles);
    int handle = live->edit.handle;
    if (live->edit.tool != TOOL_SELECT || handle < 0 || (size_t)handle >= count)
        return false;
    house_edit_drag_begin(live, &handles[handle], HOLD_KEYS);
    return true;
}

bool house_edit_hand_type(HouseLive *live, const char *letters) {
    if (!live->edit.gesture && !(house_edit_field_begins(letters) && take_focused(live)))
        return false;
    return house_edit_field_type(live, letters);
}

bool house_edit_hand_enter(HouseLive *live) {
    HouseEdit *edit = &live->edit;
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

bool house_edit_hand_back(HouseLive *live) {
    const EditGesture *gesture = live->edit.gesture;
    if (!gesture)
        return false;
    if (house_edit_field_back(live))
        return true;
    if (gesture->back)
        gesture->back(live);
    return true;
}

bool house_edit_hand_escape(HouseLive *live) {
    HouseEdit *edit = &live->edit;
    if (*edit->typed) {
        edit->fields[edit->field].typed = false;
        *edit->typed = *edit->wrong = 0;
        house_edit_gesture_follow(live);
    } else if (edit->gesture && edit->gesture->escape) {
        edit->gesture->escape(live);
    } else if (edit->gesture) {
        house_edit_gesture_drop(live);
    } else if (edit->tool != TOOL_SELECT) {
        house_edit_hand_take(live, TOOL_SELECT);
    } else if (edit->handle >= 0) {
        edit->handle = -1;
    } else if (edit->id_count) {
        house_edit_select_only(live, NULL);
    } else {
        return false;
    }
    return true;
}
