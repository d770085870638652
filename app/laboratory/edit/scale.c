#include "laboratory/edit/scale.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/edit/chain.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/marks.h"
#include "laboratory/edit/measure.h"

#define STEP "Set the scale"

static const double LEAST_APART = 0.01; /* m, least distance of two points that define a scale */

/* Members of elements that are lengths or places on the floor; heights and angles stay. */
static const char *const members[] = {"points",  "thickness", "at", "width", "centre", "size",
                                      "outline", "from",      "to", "via",   "area",   "box"};

/* Returns a copy of a number, or of lists of numbers, times a factor. */
static json_t *scaled(const json_t *value, double factor) {
    if (json_is_number(value))
        return json_number(snap_tidy(json_number_value(value) * factor));
    if (!json_is_array(value))
        return json_copy((json_t *)value);
    json_t *list = json_array();
    size_t i;
    const json_t *inner;
    json_array_foreach((json_t *)value, i, inner) json_array_append_new(list, scaled(inner, factor));
    return list;
}

static void scale_element(Editor *edit, const char *id, double factor) {
    for (size_t m = 0; m < sizeof members / sizeof *members; m++) {
        const json_t *value = json_object_get(draft_element(edit->draft, id), members[m]);
        if (value)
            draft_set(edit->draft, id, members[m], scaled(value, factor));
    }
}

/* Scales all elements, within an open step. */
static void scale_all(Editor *edit, double factor) {
    for (DraftList list = 0; list < DRAFT_LISTS; list++)
        for (size_t i = 0; i < draft_count(edit->draft, list); i++) {
            char id[EDIT_NAME];
            snprintf(id, sizeof id, "%s", json_string_value(json_object_get(draft_at(edit->draft, list, i), "id")));
            scale_element(edit, id, factor);
        }
}

/* Moves the measured distances with the house. */
static void scale_measures(Editor *edit, double factor) {
    for (size_t i = 0; i < edit->measure_count; i++) {
        edit->measures[i].from = vec2_scale(edit->measures[i].from, factor);
        edit->measures[i].to = vec2_scale(edit->measures[i].to, factor);
    }
    edit->rescaled = true;
}

bool edit_scale_set(Editor *edit, double length, Fault *fault) {
    if (!edit->measure_count) {
        fault_add(fault, "first measure the known distance (M)");
        return false;
    }
    EditMeasure *last = &edit->measures[edit->measure_count - 1];
    double factor = length / vec2_distance(last->from, last->to);
    char name[EDIT_NAME];
    snprintf(name, sizeof name, STEP ", %.4g times", factor);
    edit_gesture_begin_step(edit, name);
    scale_all(edit, factor);
    if (!edit_gesture_end_step(edit, fault))
        return false;
    scale_measures(edit, factor);
    return true;
}

/* The gesture ------------------------------------------------------------------------------------------------------ */

static const EditGesture scale_gesture;

bool edit_scale_in_hand(const Editor *edit) {
    return edit->tool == TOOL_MEASURE && edit->chosen_rows[TOOL_MEASURE] == ITEM_SET_SCALE;
}

static bool has_both(const Editor *edit) {
    return edit->chain.count == 2;
}

static double drawn(const Editor *edit) {
    return vec2_distance(edit->chain.points[0], edit->chain.points[1]);
}

static void list_fields(Editor *edit) {
    static const char *const place[] = {"x", "y"}, *const length[] = {"real length"}, *const metres[] = {"m", "m"};
    edit_field_list(edit, has_both(edit) ? length : place, metres, has_both(edit) ? 1 : 2);
}

void edit_scale_begin(Editor *edit, bool keys) {
    edit->scales = false;
    edit_gesture_begin(edit, &scale_gesture, STEP, keys);
    list_fields(edit);
    edit_gesture_update(edit);
}

static void update(Editor *edit) {
    EditTarget *now = &edit->now;
    if (has_both(edit)) {
        now->amount = drawn(edit);
        edit_field_typed(edit, 0, &now->amount);
        edit_field_show(edit, 0, now->amount);
        return;
    }
    now->at = edit_gesture_snap(
        edit, (SnapAsk){.along = NAN, .faces = true, .from = edit->chain.count ? edit->chain.points : NULL});
    edit_field_typed(edit, 0, &now->at.x);
    edit_field_typed(edit, 1, &now->at.y);
    edit_field_show(edit, 0, now->at.x);
    edit_field_show(edit, 1, now->at.y);
}

/* The house keeps its size until the length is confirmed, or it would jump at each typed digit. */
static void make(Editor *edit) {
    if (edit->scales && has_both(edit))
        scale_all(edit, edit->now.amount / drawn(edit));
}

static bool finish(Editor *edit) {
    double factor = edit->now.amount / drawn(edit);
    edit->scales = true;
    bool good = edit->now.amount > 0 && edit_gesture_end(edit);
    edit->scales = false;
    if (!good)
        return false;
    edit->chosen_rows[TOOL_MEASURE] = ITEM_MEASURE;
    scale_measures(edit, factor);
    return true;
}

static bool confirm(Editor *edit, bool keys) {
    EditChain *chain = &edit->chain;
    if (has_both(edit))
        return keys && finish(edit); /* clicks are ignored while the length is typed */
    if (chain->count == 1 && vec2_distance(chain->points[0], edit->now.at) < LEAST_APART)
        return false;
    chain->points = memory_reserve(chain->points, &chain->capacity, chain->count + 1, sizeof *chain->points);
    chain->points[chain->count++] = edit->now.at;
    list_fields(edit);
    edit_gesture_update(edit);
    return true;
}

static bool back(Editor *edit) {
    if (edit->chain.count <= 1) {
        edit_gesture_cancel(edit);
        return true;
    }
    edit->chain.count--;
    list_fields(edit);
    edit_gesture_update(edit);
    return true;
}

static void release(Editor *edit, bool moved) {
    if (moved && !has_both(edit))
        confirm(edit, false);
}

static void describe(Editor *edit, Text *text) {
    if (has_both(edit))
        text_format(text, "%.2f m as drawn: type the real length, then press Enter.", drawn(edit));
    else
        text_add(text, "Click a second point at a known distance from the first.");
}

static void show(Editor *edit) {
    if (edit->chain.count)
        edit_marks_line(edit, edit->chain.points[0], has_both(edit) ? edit->chain.points[1] : edit->now.at);
}

static const EditGesture scale_gesture = {.update = update,
                                          .make = make,
                                          .confirm = confirm,
                                          .back = back,
                                          .release = release,
                                          .describe = describe,
                                          .show = show,
                                          .end = edit_chain_clear};
