#include "plan/plan_json.h"

#include <string.h>

#include "base/json.h"
#include "plan/plan_tables.h"
#include "plan/snap.h"

const char *plan_json_text(const json_t *element, const char *member) {
    const char *text = json_string_value(json_object_get(element, member));
    return text ? text : "";
}

json_t *plan_json_point(Vec2 point) {
    return json_pack("[o,o]", json_number(point.x), json_number(point.y));
}

json_t *plan_json_points(const Vec2 *points, size_t count) {
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(list, plan_json_point(points[i]));
    return list;
}

json_t *plan_json_with(json_t *element, const char *member, json_t *value) {
    json_t *with = json_copy(element); /* shallow: the members are shared */
    if (value)
        json_object_set_new(with, member, value);
    else
        json_object_del(with, member);
    return with;
}

/* Moving ---------------------------------------------------------------------------------------------------------- */

static bool is_point(const json_t *value) {
    return json_array_size(value) == 2 && json_is_number(json_array_get(value, 0)) &&
           json_is_number(json_array_get(value, 1));
}

static json_t *point_moved(const json_t *value, Vec2 by) {
    double x = json_number_value(json_array_get(value, 0)), y = json_number_value(json_array_get(value, 1));
    return plan_json_point(vec2(by.x != 0 ? snap_tidy(x + by.x) : x, by.y != 0 ? snap_tidy(y + by.y) : y));
}

/* Moves a point, or a list of points; NULL: neither. */
static json_t *place_moved(const json_t *value, Vec2 by) {
    if (is_point(value))
        return point_moved(value, by);
    json_t *moved = json_array();
    for (size_t i = 0; i < json_array_size(value) && moved; i++) {
        const json_t *point = json_array_get(value, i);
        if (is_point(point)) {
            json_array_append_new(moved, point_moved(point, by));
        } else {
            json_decref(moved);
            moved = NULL;
        }
    }
    return moved;
}

json_t *plan_json_moved(json_t *element, Vec2 by) {
    static const char *const places[] = {"points", "centre", "outline", "from", "to", "at", "area", "via"};
    json_t *moved = json_copy(element);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        const json_t *value = json_object_get(element, places[i]);
        json_t *there = json_is_array(value) ? place_moved(value, by) : NULL;
        if (there)
            json_object_set_new(moved, places[i], there);
    }
    return moved;
}

/* Names ----------------------------------------------------------------------------------------------------------- */

/* Replaces or removes an id in a list of ids; NULL: the list does not contain it. */
static json_t *list_renamed(const json_t *list, const char *from, const char *to) {
    bool found = false;
    json_t *renamed = json_array();
    for (size_t i = 0; i < json_array_size(list); i++) {
        json_t *value = json_array_get(list, i);
        bool named = json_is_string(value) && strcmp(json_string_value(value), from) == 0;
        found |= named;
        if (!named)
            json_array_append(renamed, value);
        else if (to)
            json_array_append_new(renamed, json_string(to));
    }
    if (found)
        return renamed;
    json_decref(renamed);
    return NULL;
}

json_t *plan_json_renamed(json_t *element, const char *from, const char *to) {
    static const char *const names[] = {"id", "wall", "exit"};
    json_t *renamed = json_incref(element);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strcmp(plan_json_text(renamed, names[i]), from) != 0)
            continue;
        json_t *with = plan_json_with(renamed, names[i], to ? json_string(to) : NULL);
        json_decref(renamed);
        renamed = with;
    }
    json_t *people = list_renamed(json_object_get(renamed, "people"), from, to);
    if (people) {
        json_t *with = plan_json_with(renamed, "people", people);
        json_decref(renamed);
        renamed = with;
    }
    return renamed;
}

bool plan_json_is_empty(const json_t *list) {
    return json_is_array(list) && json_array_size(list) == 0;
}

/* Reading --------------------------------------------------------------------------------------------------------- */

static bool check_list(const json_t *pieces, const char *key, Fault *fault) {
    const json_t *list = json_object_get(pieces, key);
    if (list && !json_is_array(list)) {
        fault_add(fault, "the pasted pieces cannot be used: \"%s\" must be a list [ ... ]", key);
        return false;
    }
    for (size_t i = 0; i < json_array_size(list); i++)
        if (!*plan_json_text(json_array_get(list, i), "id")) {
            fault_add(fault, "the pasted pieces cannot be used: number %zu of \"%s\" has no id", i + 1, key);
            return false;
        }
    return true;
}

json_t *plan_json_read(const char *text, Fault *fault) {
    json_error_t error;
    bool fits = strlen(text) <= JSON_LARGEST_FILE;
    json_t *pieces = fits ? json_loads(text, JSON_REJECT_DUPLICATES, &error) : NULL;
    bool good = strcmp(plan_json_text(pieces, "format"), "clearance-pieces") == 0 ||
                strcmp(plan_json_text(pieces, "format"), "clearance-house") == 0;
    if (!pieces && fits && strstr(text, "\"clearance-"))
        fault_add(fault, "the pasted text is broken at its line %d, column %d: %s", error.line, error.column,
                  error.text);
    else if (!good)
        fault_add(
            fault,
            "the pasted text is not part of a house: copy elements here first, or paste the text of a house file");
    for (size_t l = 0; good && l < PLAN_LISTS; l++)
        good = check_list(pieces, plan_tables_lists[l].key, fault);
    if (good)
        return pieces;
    json_decref(pieces);
    return NULL;
}
