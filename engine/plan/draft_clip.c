#include "plan/draft_clip.h"

#include <string.h>

#include "base/json.h"
#include "base/text.h"
#include "plan/draft_change.h"
#include "plan/plan_json.h"
#include "plan/plan_tables.h"

char *draft_clip_copy(const Draft *draft, const char *const *ids, size_t id_count) {
    json_t *pieces = json_pack("{s:s, s:i}", "format", "clearance-pieces", "version", 1);
    size_t found = 0;
    for (int l = 0; l < DRAFT_LISTS; l++) {
        json_t *list = json_array();
        for (size_t i = 0; i < draft_count(draft, (DraftList)l); i++) {
            json_t *element = draft_at(draft, (DraftList)l, i);
            if (text_is_among(plan_json_text(element, "id"), ids, id_count) ||
                (l == DRAFT_DOORS && text_is_among(plan_json_text(element, "wall"), ids, id_count)))
                json_array_append(list, element);
        }
        found += json_array_size(list);
        if (json_array_size(list))
            json_object_set(pieces, plan_tables_lists[l].key, list);
        json_decref(list);
    }
    char *text = found ? json_line(pieces) : NULL;
    json_decref(pieces);
    return text;
}

/* Adds the pieces and returns their new names: "old" to "new". */
static json_t *new_names(Draft *draft, const json_t *pieces) {
    json_t *names = json_object();
    for (int l = 0; l < DRAFT_LISTS; l++) {
        const json_t *list = json_object_get(pieces, plan_tables_lists[l].key);
        for (size_t i = 0; i < json_array_size(list); i++) {
            /* the piece is added at once, so that the next name differs */
            const char *id = draft_add(draft, (DraftList)l, json_incref(json_array_get(list, i)));
            json_object_set_new(names, plan_json_text(json_array_get(list, i), "id"), json_string(id));
        }
    }
    return names;
}

/* Returns an added piece with the new names of the others; steals nothing. */
static json_t *renamed_by(json_t *element, json_t *names) {
    static const char *const references[] = {"wall", "exit"};
    json_t *renamed = json_copy(element), *people = json_object_get(element, "people");
    for (size_t i = 0; i < sizeof references / sizeof *references; i++) {
        json_t *name = json_object_get(names, plan_json_text(element, references[i]));
        if (name)
            json_object_set(renamed, references[i], name);
    }
    if (!json_is_array(people))
        return renamed;
    json_t *list = json_array();
    for (size_t i = 0; i < json_array_size(people); i++) {
        json_t *id = json_array_get(people, i);
        json_t *name = json_is_string(id) ? json_object_get(names, json_string_value(id)) : NULL;
        json_array_append(list, name ? name : id);
    }
    json_object_set_new(renamed, "people", list);
    return renamed;
}

bool draft_clip_paste(Draft *draft, const char *text, Vec2 by, const char ***ids, size_t *id_count, Fault *fault) {
    json_t *pieces = plan_json_read(text, fault);
    if (!pieces)
        return false;
    size_t first[DRAFT_LISTS], capacity = 0;
    for (int l = 0; l < DRAFT_LISTS; l++)
        first[l] = draft_count(draft, (DraftList)l);
    json_t *names = new_names(draft, pieces);
    *ids = NULL;
    *id_count = 0;
    for (int l = 0; l < DRAFT_LISTS; l++)
        for (size_t i = first[l]; i < draft_count(draft, (DraftList)l); i++) {
            json_t *renamed = renamed_by(draft_at(draft, (DraftList)l, i), names);
            json_t *moved = plan_json_moved(renamed, by);
            json_decref(renamed);
            draft_change_element(draft, (DraftList)l, i, moved);
            *ids = memory_reserve(*ids, &capacity, *id_count + 1, sizeof **ids);
            (*ids)[(*id_count)++] = plan_json_text(moved, "id");
        }
    json_decref(names);
    json_decref(pieces);
    return true;
}
