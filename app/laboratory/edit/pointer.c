#include "laboratory/edit/pointer.h"

#include <string.h>

#include "laboratory/edit/chain.h"
#include "laboratory/edit/drag.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/handle.h"
#include "laboratory/edit/image.h"
#include "laboratory/edit/measure.h"
#include "laboratory/edit/place.h"
#include "laboratory/edit/scale.h"
#include "laboratory/edit/select.h"

static const double STIR = 0.4; /* share of the reach: pointer travel below this is a click, not a drag */

static bool is_chain(EditTool tool) {
    return tool == TOOL_WALL || tool == TOOL_MEASURE || tool == TOOL_AREA || tool == TOOL_ROUTE;
}

static void begin(Editor *edit, bool keys) {
    if (edit->tool == TOOL_IMAGE)
        edit_image_begin(edit, keys);
    else if (edit_scale_in_hand(edit))
        edit_scale_begin(edit, keys);
    else if (is_chain(edit->tool))
        edit_chain_begin(edit, keys);
    else
        edit_place_begin(edit, keys);
}

static bool can_begin(const Editor *edit) {
    if (edit->tool == TOOL_IMAGE)
        return draft_plan(edit->draft)->background.image;
    if (edit->tool == TOOL_DOOR || edit->tool == TOOL_EXIT)
        return draft_plan(edit->draft)->wall_count;
    return edit->tool != TOOL_ROUTE || edit_chain_route_person(edit);
}

/* Changes the tool; the points drawn so far stay. */
void edit_pointer_set_tool(Editor *edit, EditTool tool) {
    if (edit->gesture && edit->gesture->escape)
        edit->gesture->escape(edit);
    edit_gesture_cancel(edit);
    edit->pending = PENDING_NOTHING;
    edit->down = false;
    edit->handle = -1;
    edit->placed = edit->cures = false;
    edit->tool = tool < EDIT_TOOLS ? tool : TOOL_SELECT;
}

/* The pointer --------------------------------------------------------------------------------------------------------
 */

static void store_pointer(Editor *edit, const Pointer *pointer) {
    edit->pointer = *pointer;
    edit->seen = true;
    edit->placed &= vec2_distance(pointer->at, edit->placed_at) <= pointer->reach;
    if (edit->clicked && vec2_distance(pointer->at, edit->keys_at) > STIR * pointer->reach)
        edit->keys = edit->clicked = false;
}

/* Grabs the handle under the press position; looks it up again, since the plan may have changed since the press. */
static void begin_handle(Editor *edit, EditGrab how) {
    Pointer was = edit->pointer;
    EditHandle handle;
    was.at = edit->pressed;
    edit_select_sync(edit);
    if (edit_handle_at(edit, &was, &handle))
        edit_drag_begin(edit, &handle, how);
}

/* Begins the pending gesture: the button is down and the pointer has moved. */
static void begin_pending(Editor *edit) {
    EditPending pending = edit->pending;
    edit->pending = PENDING_NOTHING;
    if (pending == PENDING_HANDLE)
        begin_handle(edit, GRAB_DRAG);
    else if (pending == PENDING_WHOLE)
        edit_drag_whole(edit);
    else if (pending == PENDING_BOX)
        edit_drag_box(edit);
}

void edit_pointer_move(Editor *edit, const Pointer *pointer) {
    store_pointer(edit, pointer);
    if (edit->down && !edit->moved && vec2_distance(pointer->at, edit->pressed) > STIR * pointer->reach) {
        edit->moved = true;
        begin_pending(edit);
    }
    edit_gesture_update(edit);
}

static bool is_room(const Editor *edit, const char *id) {
    size_t index;
    return draft_find(edit->draft, id, &index) == DRAFT_ROOMS;
}

static void press_select(Editor *edit) {
    EditHandle handle;
    edit->pending = PENDING_BOX;
    if (!edit->pointer.more && edit_handle_at(edit, &edit->pointer, &handle)) {
        edit->pending = PENDING_HANDLE;
        return;
    }
    const char *id = edit_select_at(edit, edit->pointer.at);
    if (!id || is_room(edit, id))
        return; /* a room is selected at the release, unless a rectangle is drawn */
    edit->pending = PENDING_NOTHING;
    if (edit->pointer.more) {
        edit_select_toggle(edit, id);
        return;
    }
    if (!edit_select_has(edit, id))
        edit_select_only(edit, id);
    edit->fixed_pressed = edit_select_fixed(edit);
    edit->pending = edit->fixed_pressed ? PENDING_NOTHING : PENDING_WHOLE;
}

void edit_pointer_press(Editor *edit, const Pointer *pointer, bool twice) {
    edit_select_sync(edit);
    store_pointer(edit, pointer);
    edit->down = true;
    edit->moved = false;
    edit->pressed = pointer->at;
    edit->pending = PENDING_NOTHING;
    edit->fixed_pressed = NULL;
    edit->keys = edit->clicked = false; /* a gesture begun by keys continues by pointer */
    if (edit->gesture && twice && edit->tool == TOOL_MEASURE && !edit_scale_in_hand(edit) && edit_measure_side(edit)) {
        edit_gesture_cancel(edit);
    } else if (edit->gesture && twice && edit->tool == TOOL_AREA && edit->chain.count == 1 &&
               edit_chain_room_here(edit)) {
        edit->down = false;
    } else if (edit->gesture) {
        edit_gesture_update(edit);
        edit->gesture->confirm(edit, false);
    } else if (edit->tool == TOOL_SELECT) {
        press_select(edit);
    } else if (can_begin(edit)) {
        begin(edit, false);
        if (edit->gesture && (is_chain(edit->tool) || edit->tool == TOOL_IMAGE))
            edit->gesture->confirm(edit, false);
    }
}

/* Ends a click. A click on a handle grabs the handle; a click outside all items selects the room, or nothing. */
static void release_pending(Editor *edit) {
    EditPending pending = edit->pending;
    edit->pending = PENDING_NOTHING;
    if (pending == PENDING_HANDLE) {
        begin_handle(edit, GRAB_CLICK);
    } else if (pending == PENDING_BOX) {
        const char *id = edit_select_at(edit, edit->pointer.at);
        if (edit->pointer.more && id)
            edit_select_toggle(edit, id);
        else if (!edit->pointer.more)
            edit_select_only(edit, id);
    }
}

void edit_pointer_release(Editor *edit, const Pointer *pointer) {
    if (!edit->down)
        return;
    edit_pointer_move(edit, pointer);
    if (edit->gesture && edit->gesture->release)
        edit->gesture->release(edit, edit->moved);
    else if (!edit->gesture && !edit->moved)
        release_pending(edit);
    edit->down = false;
    edit->pending = PENDING_NOTHING;
}

/* Keys ------------------------------------------------------------------------------------------------------------ */

/* Grabs the handle that has the keyboard focus. */
static bool grab_focused(Editor *edit) {
    EditHandle handles[EDIT_HANDLES];
    edit_select_sync(edit);
    size_t count = edit_handle_list(edit, draft_plan(edit->draft), handles);
    int handle = edit->handle;
    if (edit->tool != TOOL_SELECT || handle < 0 || (size_t)handle >= count)
        return false;
    edit_drag_begin(edit, &handles[handle], GRAB_KEYS);
    return true;
}

bool edit_pointer_type(Editor *edit, const char *characters) {
    if (!edit->gesture && !(edit_field_begins(characters) && grab_focused(edit)))
        return false;
    if (!edit_field_type(edit, characters))
        return false;
    edit_gesture_update(edit);
    return true;
}

bool edit_pointer_nudge(Editor *edit, Vec2 by) {
    EditField *fields = edit->fields;
    if (!edit->gesture && edit->tool != TOOL_SELECT && edit->pointer.nowhere && !edit->id_count && can_begin(edit))
        begin(edit, true);
    if (edit->gesture && edit->keys && edit->gesture->nudge && edit->gesture->nudge(edit, by))
        return true;
    if (!edit->gesture || !edit->keys || edit->field_count < 2 || strcmp(fields[0].name, "x") != 0)
        return false;
    fields[0].value = snap_tidy(fields[0].value + by.x);
    fields[1].value = snap_tidy(fields[1].value + by.y);
    fields[0].typed = fields[1].typed = fields[0].moved = fields[1].moved = true;
    edit_gesture_update(edit);
    return true;
}

bool edit_pointer_enter(Editor *edit) {
    if (edit->gesture) {
        if (!*edit->typed_error)
            edit->gesture->confirm(edit, true);
        return true;
    }
    if (edit->tool == TOOL_SELECT)
        return grab_focused(edit);
    if (can_begin(edit))
        begin(edit, true);
    return true;
}

bool edit_pointer_back(Editor *edit) {
    const EditGesture *gesture = edit->gesture;
    if (!gesture)
        return false;
    if (edit_field_back(edit)) {
        edit_gesture_update(edit);
        return true;
    }
    if (gesture->back)
        gesture->back(edit);
    return true;
}

bool edit_pointer_escape(Editor *edit) {
    if (*edit->typed) {
        edit->fields[edit->field].typed = false;
        *edit->typed = *edit->typed_error = 0;
        edit_gesture_update(edit);
    } else if (edit->gesture && edit->gesture->escape) {
        edit->gesture->escape(edit);
    } else if (edit->gesture) {
        edit_gesture_cancel(edit);
    } else if (edit->tool != TOOL_SELECT) {
        edit_pointer_set_tool(edit, TOOL_SELECT);
    } else if (edit->handle >= 0) {
        edit->handle = -1;
    } else if (edit->id_count) {
        edit_select_only(edit, NULL);
    } else {
        return false;
    }
    return true;
}
