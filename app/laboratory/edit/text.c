#include "laboratory/edit/text.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "base/quantity.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/select.h"

enum { POINTS_MOST = 1024 /* corners in a text */ };

static const char *const kind_names[DRAFT_LISTS] = {"wall", "door",   "furniture", "room",
                                                    "exit", "person", "crowd",     "route"};

static void add(Editor *edit, size_t *count, EditText text) {
    edit->texts = memory_reserve(edit->texts, &edit->text_capacity, *count + 1, sizeof *edit->texts);
    edit->texts[(*count)++] = text;
}

/* Corners and times ------------------------------------------------------------------------------------------------ */

/* Writes the member of an element as it is typed. False: it is too long for a field. */
typedef bool (*Write)(const json_t *element, char text[EDITOR_TEXT_MOST]);

/* Sets the member by what was typed; false: the reason is a fault. */
typedef bool (*Read)(Draft *draft, const char *id, const char *typed, Fault *fault);

static bool write_points(const json_t *points, char text[EDITOR_TEXT_MOST]) {
    size_t i, length = 0;
    json_t *point;
    *text = 0;
    json_array_foreach(points, i, point) {
        double x = json_number_value(json_array_get(point, 0)), y = json_number_value(json_array_get(point, 1));
        length += (size_t)snprintf(text + length, EDITOR_TEXT_MOST - length, "%s%.9g %.9g", i ? "; " : "", x, y);
        if (length >= EDITOR_TEXT_MOST)
            return false;
    }
    return true;
}

/* The points of a wall, a room or an exit. */
typedef struct PointKind {
    const char *each, *all, *example; /* "corner", "corners", "0 0; 4 0; 4 3" */
    size_t least, most;
} PointKind;

/* Reads "x y; x y" in m. Returns the number of points; 0: the reason is a fault. */
static size_t read_points(const char *typed, const PointKind *kind, Vec2 points[POINTS_MOST], Fault *fault) {
    char words[EDITOR_TEXT_MOST], reason[QUANTITY_REASON] = "it needs two numbers", *rest = words, *corner;
    size_t count = 0;
    snprintf(words, sizeof words, "%s", typed);
    while ((corner = strsep(&rest, ";"))) {
        char *numbers = corner, *x = strtok_r(numbers, " ", &numbers), *y = strtok_r(NULL, " ", &numbers);
        if (!x && !rest && count)
            break; /* a semicolon at the end */
        bool pair = x && y && !strtok_r(NULL, " ", &numbers);
        if (count == POINTS_MOST || !pair || !quantity_read(x, "m", &points[count].x, reason) ||
            !quantity_read(y, "m", &points[count].y, reason)) {
            if (count == POINTS_MOST)
                snprintf(reason, sizeof reason, "there may be at most %d", POINTS_MOST);
            fault_add(fault, "%s %zu: %s; type x and y in m, and a semicolon between %s: %s", kind->each, count + 1,
                      reason, kind->all, kind->example);
            return 0;
        }
        count++;
    }
    if (count >= kind->least && count <= kind->most)
        return count;
    fault_add(fault, "%zu %s: there must be %s%zu; type x and y in m of each: %s", count,
              count == 1 ? kind->each : kind->all, kind->least == kind->most ? "" : "at least ", kind->least,
              kind->example);
    return 0;
}

static bool set_corners(Draft *draft, const char *id, const char *member, size_t least, const char *typed,
                        Fault *fault) {
    const PointKind kind = {"corner", "corners", "0 0; 4 0; 4 3", least, POINTS_MOST};
    Vec2 points[POINTS_MOST];
    size_t count = read_points(typed, &kind, points, fault);
    return count && draft_set_points(draft, id, member, points, count);
}

static bool write_wall(const json_t *wall, char text[EDITOR_TEXT_MOST]) {
    return write_points(json_object_get(wall, "points"), text);
}

static bool read_wall(Draft *draft, const char *id, const char *typed, Fault *fault) {
    return set_corners(draft, id, "points", 2, typed, fault);
}

static bool write_room(const json_t *room, char text[EDITOR_TEXT_MOST]) {
    return write_points(json_object_get(room, "outline"), text);
}

static bool read_room(Draft *draft, const char *id, const char *typed, Fault *fault) {
    return set_corners(draft, id, "outline", 3, typed, fault);
}

static bool write_exit(const json_t *exit, char text[EDITOR_TEXT_MOST]) {
    json_t *ends = json_pack("[OO]", json_object_get(exit, "from"), json_object_get(exit, "to"));
    bool fits = write_points(ends, text);
    json_decref(ends);
    return fits;
}

static bool read_exit(Draft *draft, const char *id, const char *typed, Fault *fault) {
    static const PointKind kind = {"end", "ends", "0 1; 0 2", 2, 2};
    Vec2 ends[POINTS_MOST];
    return read_points(typed, &kind, ends, fault) && draft_set_point(draft, id, "from", ends[0]) &&
           draft_set_point(draft, id, "to", ends[1]);
}

static bool write_closing(const json_t *exit, char text[EDITOR_TEXT_MOST]) {
    const json_t *closes = json_object_get(exit, "closes");
    snprintf(text, EDITOR_TEXT_MOST, "never");
    if (json_is_number(closes))
        snprintf(text, EDITOR_TEXT_MOST, "%.9g s", json_number_value(closes));
    return true;
}

static bool read_closing(Draft *draft, const char *id, const char *typed, Fault *fault) {
    char reason[QUANTITY_REASON];
    double closes;
    if (!*typed || strcasecmp(typed, "never") == 0)
        return draft_set(draft, id, "closes", NULL);
    if (!quantity_read(typed, "s", &closes, reason)) {
        fault_add(fault, "%.60s: %s; type a time in s, or never", typed, reason);
        return false;
    }
    return draft_set_number(draft, id, "closes", closes);
}

/* A member that is typed as a text though it is none in the file. */
typedef struct Shape {
    DraftList list;
    const char *member, *group, *label, *step, *help;
    Write write;
    Read read;
} Shape;

static const Shape shapes[] = {
    {DRAFT_WALLS, "corners", "Shape", "corners, m", "Change the corners of",
     "Centre line: x and y of each corner, in m.", write_wall, read_wall},
    {DRAFT_ROOMS, "corners", "Shape", "corners, m", "Change the corners of", "Outline: x and y of each corner, in m.",
     write_room, read_room},
    {DRAFT_EXITS, "ends", "Line and times", "ends, m", "Change the ends of",
     "Line to cross: x and y of both ends, in m.", write_exit, read_exit},
    {DRAFT_EXITS, "closes", "Line and times", "closes at", "Change the closing time of",
     "Time from which nobody can leave by it, or never.", write_closing, read_closing},
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

static const Shape *find_shape(DraftList list, const char *member) {
    for (size_t i = 0; i < SHAPES; i++)
        if (shapes[i].list == list && strcmp(shapes[i].member, member) == 0)
            return &shapes[i];
    return NULL;
}

static void add_shapes(Editor *edit, size_t *count, DraftList list, const char *id, const json_t *element) {
    char text[EDITOR_TEXT_MOST];
    for (size_t i = 0; i < SHAPES; i++)
        if (shapes[i].list == list && shapes[i].write(element, text))
            add(edit, count,
                (EditText){text_in_arena(&edit->text_arena, "%s.%s.%s", kind_names[list], id, shapes[i].member),
                           shapes[i].group, shapes[i].label, arena_text(&edit->text_arena, text), shapes[i].help});
}

/* Texts ------------------------------------------------------------------------------------------------------------ */

static bool is_named(DraftList list) {
    return list == DRAFT_FURNITURE || list == DRAFT_ROOMS;
}

static void add_selected(Editor *edit, size_t *count) {
    const char *id = edit->ids[edit->id_count - 1];
    size_t index;
    DraftList list = draft_find(edit->draft, id, &index);
    if (list == DRAFT_LISTS)
        return;
    static const char group[] = "Names"; /* the thing itself is named above them */
    const char *name = json_string_value(json_object_get(draft_at(edit->draft, list, index), "name"));
    if (is_named(list))
        add(edit, count,
            (EditText){text_in_arena(&edit->text_arena, "%s.%s.name", kind_names[list], id), group, "name",
                       arena_text(&edit->text_arena, name ? name : ""), "Name on the plan."});
    add(edit, count,
        (EditText){text_in_arena(&edit->text_arena, "%s.%s.id", kind_names[list], id), group, "id",
                   arena_text(&edit->text_arena, id), "Short name in the file, for references and settings."});
    add_shapes(edit, count, list, id, draft_at(edit->draft, list, index));
}

const EditText *edit_text_list(Editor *edit, size_t *count) {
    const Plan *plan = draft_plan(edit->draft);
    *count = 0;
    arena_clear(&edit->text_arena);
    if (edit->id_count)
        add_selected(edit, count);
    add(edit, count,
        (EditText){"house.name", "House", "name", arena_text(&edit->text_arena, plan->name), "Name of the house."});
    add(edit, count,
        (EditText){"house.note", "House", "note", arena_text(&edit->text_arena, plan->note),
                   "Source of the plan, and what is assumed."});
    return edit->texts;
}

/* Splits "KIND.ID.MEMBER" into its parts; false: there is no such element. */
static bool split(const Editor *edit, const char *name, char id[EDIT_NAME], const char **member) {
    size_t index, kind = strcspn(name, ".");
    const char *last = strrchr(name, '.');
    if (!name[kind] || last == name + kind || (size_t)(last - name) - kind > EDIT_NAME)
        return false;
    snprintf(id, EDIT_NAME, "%.*s", (int)((size_t)(last - name) - kind - 1), name + kind + 1);
    *member = last + 1;
    DraftList list = draft_find(edit->draft, id, &index);
    return list < DRAFT_LISTS && strlen(kind_names[list]) == kind && strncmp(kind_names[list], name, kind) == 0 &&
           (strcmp(*member, "id") == 0 || (strcmp(*member, "name") == 0 && is_named(list)) ||
            find_shape(list, *member));
}

static bool rename_element(Editor *edit, const char *id, const char *to, Fault *fault) {
    char name[EDIT_NAME], item[EDIT_NAME];
    bool selected = edit_select_has(edit, id);
    edit_select_name(edit, id, item);
    snprintf(name, sizeof name, "Rename %.60s to %.40s", item, to);
    edit_gesture_begin_step(edit, name);
    if (!draft_rename(edit->draft, id, to, fault)) {
        draft_cancel(edit->draft);
        return false;
    }
    bool good = edit_gesture_end_step(edit, fault);
    if (good && selected)
        edit_select_only(edit, to);
    return good;
}

/* Changes a member that is typed as a text, in one step. */
static bool reshape(Editor *edit, const char *id, const Shape *shape, const char *typed, Fault *fault) {
    char step[EDIT_NAME], item[EDIT_NAME];
    edit_select_name(edit, id, item);
    snprintf(step, sizeof step, "%s %.80s", shape->step, item);
    edit_gesture_begin_step(edit, step);
    if (shape->read(edit->draft, id, typed, fault))
        return edit_gesture_end_step(edit, fault);
    draft_cancel(edit->draft);
    return false;
}

bool edit_text_set(Editor *edit, const char *name, const char *value, Fault *fault) {
    char id[EDIT_NAME], step[EDIT_NAME], item[EDIT_NAME];
    const char *member;
    if (strcmp(name, "house.name") == 0 || strcmp(name, "house.note") == 0) {
        edit_gesture_begin_step(edit, strcmp(name, "house.name") == 0 ? "Change the name of the house"
                                                                      : "Change the note of the house");
        draft_set_house(edit->draft, name + 6, json_string(value));
        return edit_gesture_end_step(edit, fault);
    }
    if (!split(edit, name, id, &member)) {
        fault_add(fault, "there is no text called \"%.100s\"", name);
        return false;
    }
    if (strcmp(member, "id") == 0)
        return rename_element(edit, id, value, fault);
    size_t index;
    const Shape *shape = find_shape(draft_find(edit->draft, id, &index), member);
    if (shape)
        return reshape(edit, id, shape, value, fault);
    edit_select_name(edit, id, item);
    snprintf(step, sizeof step, "Name %.100s", item);
    edit_gesture_begin_step(edit, step);
    draft_set_text(edit->draft, id, "name", value);
    return edit_gesture_end_step(edit, fault);
}
