/* Actions on the selection: nudge, turn, topple, remove, copy. Each action is one step. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "plan/draft_clip.h"
#include "laboratory/edit/editor_state.h"

static const double APART =
    0.30; /* m, to the right and downwards: offset of a copy that is pasted without the pointer */

static bool is_anything(const Editor *edit, Fault *fault) {
    if (edit->id_count)
        return true;
    fault_add(fault, "nothing is selected: click on something, or Tab goes to the next");
    return false;
}

/* Opens an undo step called "VERB NAMES". */
static void open_step(Editor *edit, const char *verb) {
    char name[EDIT_NAME], things[EDIT_NAME];
    edit_select_names(edit, things);
    snprintf(name, sizeof name, "%.20s %.100s", verb, things);
    edit_gesture_open(edit, name);
}

/* Moving and turning ------------------------------------------------------------------------------------------------
 */

/* Moves a handle by setting its fields as if they were typed. */
static void nudge_fields(Editor *edit, Vec2 by) {
    EditField *fields = edit->fields;
    const EditHandle *grip = &edit->grip;
    size_t x = grip->grip == GRIP_POINT && edit->field_count == 4 ? 2 : 0;
    if (grip->list == DRAFT_DOORS) {
        const Plan *plan = &edit->begun;
        const Vec2 *ends = plan->walls[edit->now.wall].points.at + edit->now.segment;
        double along = vec2_dot(by, vec2_unit(vec2_sub(ends[1], ends[0])));
        bool wider = grip->grip == GRIP_EDGE;
        fields[wider].value += wider && grip->index == 0 ? -along : along;
        fields[wider].typed = true;
        return;
    }
    if (grip->grip == GRIP_TURN) {
        fields[0].value += fabs(by.x) > fabs(by.y) ? -by.x * 100 : by.y * 100; /* one degree per centimetre */
        fields[0].typed = true;
        return;
    }
    double widen[2] = {by.x, by.y};
    if (grip->grip == GRIP_CORNER) {
        Vec2 own = vec2_unturn(by, snap_heading(edit->now.angle));
        widen[0] = grip->index == 1 || grip->index == 2 ? own.x : -own.x;
        widen[1] = grip->index >= 2 ? own.y : -own.y;
    }
    for (size_t k = 0; k < 2; k++) {
        fields[x + k].value = snap_tidy(fields[x + k].value + widen[k]);
        fields[x + k].typed = true;
    }
}

static bool nudge_handle(Editor *edit, Vec2 by, Fault *fault) {
    EditHandle handles[EDIT_HANDLES];
    size_t count = edit_handle_list(edit, draft_plan(edit->draft), handles);
    int kept = edit->handle;
    if ((size_t)kept >= count)
        return false;
    edit_drag_begin(edit, &handles[kept], HOLD_KEYS);
    nudge_fields(edit, by);
    edit_gesture_follow(edit);
    snprintf(edit->name, sizeof edit->name, "Nudge");
    bool good = !edit->refusal && edit_gesture_settle(edit);
    if (!good) {
        fault_add(fault, "%s", edit->refusal ? edit->refusal : "it cannot go there");
        edit_gesture_drop(edit);
    }
    edit->handle = kept;
    return good;
}

bool edit_do_nudge(Editor *edit, Vec2 by, Fault *fault) {
    if (!is_anything(edit, fault))
        return false;
    if (edit->handle >= 0)
        return nudge_handle(edit, by, fault);
    uint64_t before = draft_revision(edit->draft);
    edit_gesture_open(edit, "Nudge");
    edit_shape_move(edit, draft_plan(edit->draft), by);
    if (!edit_gesture_close(edit, fault))
        return false;
    if (draft_revision(edit->draft) != before)
        return true;
    fault_add(fault, "a door moves along its wall only");
    return false;
}

bool edit_do_turn(Editor *edit, double by, Fault *fault) {
    size_t index, turned = 0;
    if (!is_anything(edit, fault))
        return false;
    open_step(edit, "Turn");
    for (size_t i = 0; i < edit->id_count; i++) {
        DraftList list = draft_find(edit->draft, edit->ids[i], &index);
        const char *member = list == DRAFT_FURNITURE ? "angle" : list == DRAFT_PEOPLE ? "heading" : NULL;
        if (!member)
            continue;
        double is = json_number_value(json_object_get(draft_element(edit->draft, edit->ids[i]), member));
        double angle = snap_tidy(remainder(is + by, 360));
        draft_set_number(edit->draft, edit->ids[i], member, angle <= -180 ? 180 : angle);
        turned++;
    }
    if (!turned)
        fault_add(fault, "only furniture and people can be turned");
    return edit_gesture_close(edit, fault) && turned;
}

/* Toppling --------------------------------------------------------------------------------------------------------- */

static bool may_topple(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    size_t index, count = 0;
    char name[EDIT_NAME];
    for (size_t i = 0; i < edit->id_count; i++) {
        if (draft_find(edit->draft, edit->ids[i], &index) != DRAFT_FURNITURE)
            continue;
        count += plan->furniture[index].topples != TOPPLE_NO;
        if (plan->furniture[index].topples != TOPPLE_NO)
            continue;
        edit_select_name(edit, edit->ids[i], name);
        fault_add(fault, "%s does not topple: choose the face that it falls to", name);
    }
    if (!count && !fault->count)
        fault_add(fault, "only furniture topples");
    return count;
}

bool edit_do_topple(Editor *edit, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    size_t index;
    if (!is_anything(edit, fault) || !may_topple(edit, fault))
        return false;
    bool lies = true;
    for (size_t i = 0; i < edit->id_count; i++)
        if (draft_find(edit->draft, edit->ids[i], &index) == DRAFT_FURNITURE &&
            plan->furniture[index].topples != TOPPLE_NO)
            lies &= plan->furniture[index].toppled;
    open_step(edit, lies ? "Stand up" : "Topple");
    for (size_t i = 0; i < edit->id_count; i++)
        if (draft_find(edit->draft, edit->ids[i], &index) == DRAFT_FURNITURE &&
            plan->furniture[index].topples != TOPPLE_NO)
            draft_set(edit->draft, edit->ids[i], "toppled", json_boolean(!lies));
    return edit_gesture_close(edit, fault);
}

/* Removing --------------------------------------------------------------------------------------------------------- */

bool edit_do_remove(Editor *edit, Fault *fault) {
    if (!edit->id_count && edit->measure_count) {
        edit->measure_count = 0;
        return true;
    }
    if (!is_anything(edit, fault))
        return false;
    if (edit->handle >= 0 && edit_split_can_join(edit))
        return edit_split_join(edit, fault);
    open_step(edit, "Remove");
    for (size_t i = 0; i < edit->id_count; i++)
        draft_remove(edit->draft, edit->ids[i]);
    return edit_gesture_close(edit, fault);
}

/* Copies ----------------------------------------------------------------------------------------------------------- */

char *edit_do_copy(const Editor *edit) {
    return edit->id_count ? draft_clip_copy(edit->draft, (const char *const *)edit->ids, edit->id_count) : NULL;
}

static bool paste(Editor *edit, const char *name, const char *text, Vec2 by, Fault *fault) {
    const char **ids = NULL;
    size_t count = 0;
    edit_gesture_open(edit, name);
    if (!draft_clip_paste(edit->draft, text, by, &ids, &count, fault)) {
        draft_cancel(edit->draft);
        return false;
    }
    Fault own = {0};
    bool good = edit_gesture_close(edit, &own);
    for (size_t i = 0; i < own.count; i++)
        fault_add(fault, "what is pasted cannot be put here: %s", own.lines[i]);
    fault_clear(&own);
    for (size_t i = 0; good && i < count; i++) {
        if (i == 0)
            edit_select_only(edit, ids[i]);
        else
            edit_select_toggle(edit, ids[i]);
    }
    memory_free(ids);
    return good;
}

bool edit_do_duplicate(Editor *edit, Fault *fault) {
    char name[EDIT_NAME], things[EDIT_NAME];
    if (!is_anything(edit, fault))
        return false;
    edit_select_names(edit, things);
    snprintf(name, sizeof name, "Duplicate %.100s", things);
    char *text = edit_do_copy(edit);
    bool good = text && paste(edit, name, text, vec2(APART, -APART), fault);
    memory_free(text);
    return good;
}

/* Extends the box by all places within a value: pairs of numbers at any depth. */
static Box include_places(Box box, const json_t *value) {
    size_t i;
    json_t *inner;
    const char *key;
    if (json_array_size(value) == 2 && json_is_number(json_array_get(value, 0)) &&
        json_is_number(json_array_get(value, 1)))
        return box_include(
            box, vec2(json_number_value(json_array_get(value, 0)), json_number_value(json_array_get(value, 1))));
    json_array_foreach(value, i, inner) box = include_places(box, inner);
    json_object_foreach((json_t *)value, key, inner) {
        if (strcmp(key, "size") != 0)
            box = include_places(box, inner);
    }
    return box;
}

/* Returns the offset of pasted pieces: their middle moves to the pointer. Without a pointer, or close to the
 * originals, each copy is placed APART farther to the right and below. */
static Vec2 paste_by(Editor *edit, const char *text, Box box) {
    Vec2 to = vec2_sub(edit->pointer.at, vec2_scale(vec2_add(box.low, box.high), 0.5));
    Vec2 by = vec2(round(to.x / SNAP_GRID) * SNAP_GRID, round(to.y / SNAP_GRID) * SNAP_GRID);
    if (edit->seen && !edit->pointer.nowhere && vec2_length(by) >= APART)
        return by;
    uint64_t digest = digest_bytes(DIGEST_START, text, strlen(text));
    edit->copies = digest == edit->pasted ? edit->copies + 1 : 1;
    edit->pasted = digest;
    return vec2(edit->copies * APART, -edit->copies * APART);
}

bool edit_do_paste(Editor *edit, const char *text, Fault *fault) {
    json_t *pieces = json_loads(text, 0, NULL);
    Box box = include_places(box_empty(), pieces);
    Vec2 by = box.low.x <= box.high.x ? paste_by(edit, text, box) : vec2(0, 0);
    json_decref(pieces);
    return paste(edit, "Paste", text, by, fault);
}
