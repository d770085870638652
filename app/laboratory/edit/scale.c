#include "laboratory/edit/scale.h"

#include <stdio.h>
#include <string.h>

#include "laboratory/edit/gesture.h"

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

bool edit_scale_set(Editor *edit, double length, Fault *fault) {
    if (!edit->measure_count) {
        fault_add(fault, "first measure the known distance (M)");
        return false;
    }
    EditMeasure *last = &edit->measures[edit->measure_count - 1];
    double factor = length / vec2_distance(last->from, last->to);
    char name[EDIT_NAME];
    snprintf(name, sizeof name, "Set the scale, %.4g times", factor);
    edit_gesture_begin_step(edit, name);
    for (DraftList list = 0; list < DRAFT_LISTS; list++)
        for (size_t i = 0; i < draft_count(edit->draft, list); i++) {
            char id[EDIT_NAME];
            snprintf(id, sizeof id, "%s", json_string_value(json_object_get(draft_at(edit->draft, list, i), "id")));
            scale_element(edit, id, factor);
        }
    if (!edit_gesture_end_step(edit, fault))
        return false;
    for (size_t i = 0; i < edit->measure_count; i++) {
        edit->measures[i].from = vec2_scale(edit->measures[i].from, factor);
        edit->measures[i].to = vec2_scale(edit->measures[i].to, factor);
    }
    return true;
}
