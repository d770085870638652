#include "laboratory/edit/text.h"

#include <stdio.h>
#include <string.h>

#include "laboratory/edit/gesture.h"
#include "laboratory/edit/select.h"

static const char *const kind_names[DRAFT_LISTS] = {"wall", "door",   "furniture", "room",
                                                    "exit", "person", "crowd",     "route"};

static void add(Editor *edit, size_t *count, EditText text) {
    edit->texts = memory_reserve(edit->texts, &edit->text_capacity, *count + 1, sizeof *edit->texts);
    edit->texts[(*count)++] = text;
}

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
           (strcmp(*member, "id") == 0 || (strcmp(*member, "name") == 0 && is_named(list)));
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
    edit_select_name(edit, id, item);
    snprintf(step, sizeof step, "Name %.100s", item);
    edit_gesture_begin_step(edit, step);
    draft_set_text(edit->draft, id, "name", value);
    return edit_gesture_end_step(edit, fault);
}
