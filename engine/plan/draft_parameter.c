#include "plan/draft_parameter.h"

#include <stdio.h>
#include <string.h>

#include "plan/plan_json.h"
#include "plan/plan_tables.h"

/* Sets a member of an object that is a member of the house: "run", "overrides". */
static void set_in_house(Draft *draft, const char *object, const char *member, json_t *value) {
    json_t *before = draft_house(draft, object), *empty = json_object();
    draft_set_house(draft, object, plan_json_with(json_is_object(before) ? before : empty, member, value));
    json_decref(empty);
}

/* Sets one number of an element's point, "at.x"; steals the value. Returns false if there is no such point. */
static bool set_component(Draft *draft, const char *id, const char *name, json_t *value) {
    char member[32];
    int used = 0;
    if (sscanf(name, "%31[a-z_].%n", member, &used) != 1 || !used ||
        (strcmp(name + used, "x") != 0 && strcmp(name + used, "y") != 0))
        return false;
    json_t *point = json_object_get(draft_element(draft, id), member);
    if (json_array_size(point) != 2)
        return false;
    json_t *moved = json_copy(point);
    json_array_set_new(moved, name[used] == 'y', value);
    return draft_set(draft, id, member, moved);
}

bool draft_parameter_set(Draft *draft, const char *name, json_t *value, Fault *fault) {
    char kind[32], id[256];
    int used = 0;
    size_t index;
    if (strncmp(name, "run.", 4) == 0 && name[4]) {
        set_in_house(draft, "run", name + 4, value);
        return true;
    }
    if (plan_is_of_profile(name)) {
        set_in_house(draft, "overrides", name, value);
        return true;
    }
    if (sscanf(name, "%31[a-z].%255[A-Za-z0-9_-].%n", kind, id, &used) == 2 && used && name[used]) {
        DraftList list = draft_find(draft, id, &index);
        if (list < DRAFT_LISTS && strcmp(plan_tables_lists[list].table.what, kind) == 0)
            return set_component(draft, id, name + used, value) || draft_set(draft, id, name + used, value);
    }
    fault_add(fault, "unknown parameter \"%.100s\"", name);
    json_decref(value);
    return false;
}
