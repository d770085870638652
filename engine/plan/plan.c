#include "plan/plan.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/file_write.h"
#include "base/json.h"
#include "base/parameters_schema.h"
#include "base/text.h"
#include "plan/plan_check.h"
#include "plan/plan_tables.h"

static const char *const plan_keys[] = {"format",    "version", "name",      "note",       "walls",  "doors",
                                        "furniture", "rooms",   "exits",     "people",     "crowds", "routes",
                                        "run",       "drivers", "overrides", "background", NULL};

/* Reading ---------------------------------------------------------------------------------------------------- */

/* Stores the position of a value, to begin errors with. */
static const char *keep_place(Plan *plan, const JsonFile *file, JsonPlace place) {
    size_t size = strlen(file->path) + 40;
    char *text = arena_allocate(&plan->arena, size);
    if (file->text)
        snprintf(text, size, "%s:%d:%d: ", file->path, place.line, place.column);
    return text;
}

/* Stores the position of a member of the root. */
static const char *place_of(Plan *plan, const JsonNode *root, const char *member) {
    JsonPlace *places = json_places(root);
    const char *key, *place = "";
    json_t *value;
    size_t i = 0;
    json_object_foreach(root->value, key, value) {
        if (strcmp(key, member) == 0)
            place = keep_place(plan, root->file, places[i]);
        i++;
    }
    memory_free(places);
    return place;
}

/* Stores the positions of people and crowds, whose errors may be found after reading. */
static void keep_places(Plan *plan, const JsonNode *root) {
    JsonNode people = json_member(root, plan_tables_lists[LIST_PEOPLE].key);
    JsonNode crowds = json_member(root, plan_tables_lists[LIST_CROWDS].key);
    JsonPlace *places = json_places(&people);
    for (size_t i = 0; i < plan->person_count; i++)
        plan->people[i].place = keep_place(plan, root->file, places[i]);
    memory_free(places);
    places = json_places(&crowds);
    for (size_t i = 0; i < plan->crowd_count; i++)
        plan->crowds[i].place = keep_place(plan, root->file, places[i]);
    memory_free(places);
}

/* Returns "door d1: ", which begins the errors of an element without a file; memory_free it. */
static char *name_element(const PlanList *list, const JsonNode *element) {
    Text name = {0};
    const char *id = json_string_value(json_object_get(element->value, "id"));
    text_format(&name, "%s %.60s: ", list->table.what, id ? id : "");
    return name.text;
}

/* Returns whether each element was read without an error (count of the list). */
static const bool *read_list(Plan *plan, const PlanList *list, const JsonNode *root, Fault *fault) {
    JsonNode node = json_member(root, list->key);
    if (node.value && !json_is_array(node.value))
        json_fault(&node, fault, "%s must be a list [ ... ]", list->key);
    size_t count = json_array_size(node.value);
    plan_tables_allocate(plan, list, count);
    bool *sound = arena_allocate(&plan->arena, count * sizeof *sound);
    for (size_t i = 0; i < count; i++) {
        JsonNode element = json_element(&node, i);
        char *name = root->file->text ? NULL : name_element(list, &element);
        JsonFile alone = {.path = name};
        if (name)
            element.file = &alone;
        sound[i] = parameters_read(&list->table, plan_tables_element(plan, list, i), &element, &plan->arena, fault);
        memory_free(name);
    }
    return sound;
}

bool plan_is_of_profile(const char *name) {
    int used = 0;
    return sscanf(name, "profile.%*63[A-Za-z0-9_-].%n", &used) == 0 && used && name[used];
}

/* Stores a profile parameter until the profiles are read. There is room in plan->overrides. */
static void keep_override(Plan *plan, const char *name, const JsonNode *node, const char *place) {
    char *value = json_line(node->value);
    plan->overrides[plan->override_count++] =
        (Override){arena_text(&plan->arena, name), arena_text(&plan->arena, value), place};
    memory_free(value);
}

/* Target of a setting's NAME. */
typedef struct Target {
    const Parameter *row;
    const void *object;
    const PlanList *list; /* NULL: the settings of the run */
    size_t index;
} Target;

/* Finds KIND.ID.NAME; NAME begins at name + used. Returns false with an error that names the possible parameters. */
static bool find_in_lists(const Plan *plan, Target *target, const char *kind, const char *id, const char *name,
                          const JsonNode *node, Fault *fault) {
    const char *kinds[PLAN_LISTS + 2] = {"profile", "run"};
    for (size_t l = 0; l < PLAN_LISTS; l++) {
        const PlanList *list = &plan_tables_lists[l];
        kinds[l + 2] = list->table.what;
        if (strcmp(list->table.what, kind) != 0)
            continue;
        size_t index = plan_tables_find(plan, list, id);
        const Parameter *row = parameters_find(&list->table, name),
                        *component = parameters_find(&list->components, name);
        if (index == SIZE_MAX) {
            json_fault(node, fault, "there is no %s \"%s\"", kind, id);
            return false;
        }
        if (!row && !component) {
            bool of_point = list->components.count && (strcmp(name, "x") == 0 || strcmp(name, "y") == 0);
            parameters_fault_unknown(of_point ? &list->components : &list->table, name, node, fault);
            return false;
        }
        *target = (Target){row ? row : component, plan_tables_element(plan, list, index), list, index};
        return true;
    }
    const char *nearest = text_nearest(kind, kinds, PLAN_LISTS + 2);
    if (nearest)
        json_fault(node, fault, "unknown kind \"%s\", did you mean \"%s\"?", kind, nearest);
    else
        json_fault(
            node, fault,
            "unknown kind \"%s\", known are wall, door, furniture, room, exit, person, crowd, route, profile, run",
            kind);
    return false;
}

/* Finds any name except a profile's. */
static bool find_target(const Plan *plan, Target *target, const char *name, const JsonNode *node, Fault *fault) {
    char kind[32], id[256];
    int used = 0;
    if (sscanf(name, "run.%n", &used) == 0 && used) {
        *target = (Target){.row = parameters_find(&plan_tables_run, name + used), .object = &plan->run};
        if (!target->row)
            parameters_fault_unknown(&plan_tables_run, name + used, node, fault);
        return target->row;
    }
    used = 0;
    if (sscanf(name, "drivers.%n", &used) == 0 && used) {
        *target = (Target){.row = parameters_find(&plan_tables_drivers, name + used), .object = &plan->drivers};
        if (!target->row)
            parameters_fault_unknown(&plan_tables_drivers, name + used, node, fault);
        return target->row;
    }
    if (sscanf(name, "%31[a-z].%255[A-Za-z0-9_-].%n", kind, id, &used) == 2 && used && name[used])
        return find_in_lists(plan, target, kind, id, name + used, node, fault);
    json_fault(node, fault,
               "\"%.80s\" is not a parameter name: it must be run.NAME, or KIND.ID.NAME such as door.d1.width or "
               "profile.manual-chair.width",
               name);
    return false;
}

/* Applies one NAME = value to the plan, or stores it for the profiles. The node points at the value, whose position
 * `place` is in the plan's arena. */
static void apply_setting(Plan *plan, const char *name, const JsonNode *node, const char *place, Fault *fault) {
    Target target;
    if (plan_is_of_profile(name)) {
        keep_override(plan, name, node, place);
        return;
    }
    if (!find_target(plan, &target, name, node, fault))
        return;
    void *object = target.list                       ? plan_tables_element(plan, target.list, target.index)
                   : target.object == &plan->drivers ? (void *)&plan->drivers
                                                     : &plan->run;
    if (object == &plan->drivers)
        plan->drivers.place = place;
    if (parameters_read_value(target.row, object, node, &plan->arena, fault) && target.list)
        plan_tables_renamed(plan, target.list, target.index);
}

const Parameter *plan_parameter(const Plan *plan, const char *name, const void **object, const char *place,
                                Fault *fault) {
    JsonFile file = {.path = place};
    JsonNode node = json_root(&file);
    Target target;
    if (!find_target(plan, &target, name, &node, fault))
        return NULL;
    *object = target.object;
    return target.row;
}

static void read_overrides(Plan *plan, const JsonNode *node, Fault *fault) {
    if (!node->value)
        return;
    if (!json_is_object(node->value)) {
        json_fault(node, fault, "overrides must be an object { \"NAME\": value }");
        return;
    }
    JsonPlace *places = json_places(node), *at = places;
    const char *key;
    json_t *value;
    json_object_foreach(node->value, key, value) {
        JsonNode member = json_member(node, key);
        apply_setting(plan, key, &member, keep_place(plan, node->file, *at++), fault);
    }
    memory_free(places);
}

/* Reads a NAME=VALUE of the command line: VALUE is a number, a list, or otherwise a word. */
static void read_setting(Plan *plan, const char *setting, Fault *fault) {
    const char *equals = strchr(setting, '=');
    if (!equals || equals == setting || !equals[1]) {
        fault_add(fault, "--set %.80s: must be NAME=VALUE, for instance door.d1.width=0.8", setting);
        return;
    }
    char name[160], path[180];
    snprintf(name, sizeof name, "%.*s", (int)(equals - setting < 150 ? equals - setting : 150), setting);
    snprintf(path, sizeof path, "--set %s: ", name);
    JsonFile file = {.path = path, .root = json_loads(equals + 1, JSON_DECODE_ANY, NULL)};
    if (!file.root)
        file.root = json_string(equals + 1);
    if (!file.root) {
        fault_add(fault, "%sthe value is not UTF-8", path);
        return;
    }
    JsonNode node = json_root(&file);
    apply_setting(plan, name, &node, arena_text(&plan->arena, path), fault);
    json_decref(file.root);
}

static void read_house(Plan *plan, const JsonNode *root, const char *const *settings, size_t setting_count,
                       Fault *fault) {
    PlanCheck check = {.plan = plan, .root = root, .fault = fault};
    json_check_keys(root, plan_keys, fault);
    plan->path = arena_text(&plan->arena, root->file->path);
    plan->name = json_read_text(root, "name", &plan->arena, fault);
    plan->note = json_read_text(root, "note", &plan->arena, fault);
    if (!json_object_get(root->value, "walls"))
        json_fault(root, fault, "a house has no \"walls\", must be a list [ ... ]");
    for (size_t l = 0; l < PLAN_LISTS; l++)
        check.sound[l] = read_list(plan, &plan_tables_lists[l], root, fault);
    JsonNode run = json_member(root, "run");
    parameters_reset(&plan_tables_run, &plan->run);
    if (run.value)
        parameters_read(&plan_tables_run, &plan->run, &run, &plan->arena, fault);
    JsonNode drivers = json_member(root, "drivers");
    parameters_reset(&plan_tables_drivers, &plan->drivers);
    if (drivers.value)
        parameters_read(&plan_tables_drivers, &plan->drivers, &drivers, &plan->arena, fault);
    plan->drivers.place = drivers.value ? place_of(plan, root, "drivers") : "";
    JsonNode background = json_member(root, "background");
    if (background.value)
        parameters_read(&plan_tables_background, &plan->background, &background, &plan->arena, fault);
    keep_places(plan, root);
    JsonNode overrides = json_member(root, "overrides");
    size_t changes = setting_count + json_object_size(overrides.value);
    plan->overrides = arena_allocate(&plan->arena, changes * sizeof *plan->overrides);
    plan_tables_index(plan, changes);
    read_overrides(plan, &overrides, fault);
    for (size_t i = 0; i < setting_count; i++)
        read_setting(plan, settings[i], fault);
    plan_check_whole(&check);
}

/* Reads a plan from a parsed file, which is released. */
static bool read_plan(Plan *plan, JsonFile *file, const char *const *settings, size_t setting_count, Fault *fault) {
    size_t before = fault->total;
    Plan read = {0};
    JsonNode root = json_root(file);
    if (json_check_header(&root, "house", "clearance-house", fault))
        read_house(&read, &root, settings, setting_count, fault);
    json_free(file);
    if (fault->total != before) {
        plan_free(&read);
        return false;
    }
    plan_free(plan);
    *plan = read;
    return true;
}

bool plan_read(Plan *plan, const char *path, const char *const *settings, size_t setting_count, Fault *fault) {
    JsonFile file = {0};
    return json_read(&file, path, fault) && read_plan(plan, &file, settings, setting_count, fault);
}

bool plan_read_text(Plan *plan, const char *path, const char *text, const char *const *settings, size_t setting_count,
                    Fault *fault) {
    JsonFile file = {0};
    return json_read_memory(&file, path, text, fault) && read_plan(plan, &file, settings, setting_count, fault);
}

bool plan_read_values(Plan *plan, const char *path, json_t *values, Fault *fault) {
    JsonFile file = {.path = "", .root = json_incref(values)};
    bool good = read_plan(plan, &file, NULL, 0, fault);
    if (good)
        plan->path = arena_text(&plan->arena, path);
    return good;
}

void plan_free(Plan *plan) {
    arena_clear(&plan->arena);
    *plan = (Plan){0};
}

/* Writing: one element a line --------------------------------------------------------------------------------- */

static void lines_add_json(Text *lines, json_t *value) {
    char *line = json_line(value);
    text_add(lines, line);
    memory_free(line);
    json_decref(value);
}

static void lines_add_list(Text *lines, const Plan *plan, const PlanList *list) {
    size_t count = plan_tables_count(plan, list);
    text_add(lines, ",\n  \"");
    text_add(lines, list->key);
    text_add(lines, "\": [");
    for (size_t i = 0; i < count; i++) {
        text_add(lines, i ? ",\n    " : "\n    ");
        lines_add_json(lines, parameters_write(&list->table, plan_tables_element(plan, list, i)));
    }
    text_add(lines, count ? "\n  ]" : "]");
}

char *plan_text(const Plan *plan) {
    Text lines = {0};
    text_add(&lines, "{\n  \"format\": \"clearance-house\", \"version\": 1,\n  \"name\": ");
    lines_add_json(&lines, json_string(plan->name));
    text_add(&lines, ",\n  \"note\": ");
    lines_add_json(&lines, json_string(plan->note));
    for (size_t l = 0; l < PLAN_LISTS; l++)
        if (l == 0 || plan_tables_count(plan, &plan_tables_lists[l]))
            lines_add_list(&lines, plan, &plan_tables_lists[l]);
    json_t *run = parameters_write(&plan_tables_run, &plan->run);
    if (json_object_size(run)) {
        text_add(&lines, ",\n  \"run\": ");
        lines_add_json(&lines, json_incref(run));
    }
    json_decref(run);
    if (plan->drivers.count || (plan->drivers.population && *plan->drivers.population)) {
        text_add(&lines, ",\n  \"drivers\": ");
        lines_add_json(&lines, parameters_write(&plan_tables_drivers, &plan->drivers));
    }
    if (plan->override_count) {
        json_t *overrides = json_object();
        for (size_t i = 0; i < plan->override_count; i++)
            json_object_set_new(overrides, plan->overrides[i].name,
                                json_loads(plan->overrides[i].value, JSON_DECODE_ANY, NULL));
        text_add(&lines, ",\n  \"overrides\": ");
        lines_add_json(&lines, overrides);
    }
    if (plan->background.image) {
        text_add(&lines, ",\n  \"background\": ");
        lines_add_json(&lines, parameters_write(&plan_tables_background, &plan->background));
    }
    text_add(&lines, "\n}\n");
    return lines.text;
}

int plan_write(const Plan *plan, const char *path) {
    char *text = plan_text(plan);
    int error = file_write_bytes(path, text, strlen(text));
    memory_free(text);
    return error;
}

/* Schema ------------------------------------------------------------------------------------------------------ */

json_t *plan_schema(void) {
    json_t *properties = json_object();
    json_object_set_new(properties, "format", json_pack("{s:s}", "const", "clearance-house"));
    json_object_set_new(properties, "version", json_pack("{s:i}", "const", 1));
    json_object_set_new(properties, "name", json_pack("{s:s, s:s}", "type", "string", "description", "displayed name"));
    json_object_set_new(
        properties, "note",
        json_pack("{s:s, s:s}", "type", "string", "description", "where the plan comes from, what is assumed"));
    for (size_t l = 0; l < PLAN_LISTS; l++) {
        const PlanList *list = &plan_tables_lists[l];
        json_object_set_new(properties, list->key,
                            json_pack("{s:s, s:o}", "type", "array", "items", parameters_schema_table(&list->table)));
    }
    json_object_set_new(properties, "run", parameters_schema_table(&plan_tables_run));
    json_object_set_new(properties, "drivers", parameters_schema_table(&plan_tables_drivers));
    json_object_set_new(properties, "background", parameters_schema_table(&plan_tables_background));
    json_object_set_new(properties, "overrides",
                        json_pack("{s:s, s:{s:s}, s:s}", "type", "object", "propertyNames", "pattern",
                                  "^(run|drivers|[a-z]+\\.[A-Za-z0-9_-]+)\\.[a-z_.]+$", "description",
                                  "parameters by their path, for instance profile.manual-chair.width"));
    return json_pack("{s:s, s:s, s:s, s:b, s:o, s:[s,s,s]}", "$schema", "https://json-schema.org/draft/2020-12/schema",
                     "title", "A house of clearance", "type", "object", "additionalProperties", 0, "properties",
                     properties, "required", "format", "version", "walls");
}

/* Look-ups ------------------------------------------------------------------------------------------------------------
 */

size_t plan_find_person(const Plan *plan, const char *id) {
    return plan_tables_find(plan, &plan_tables_lists[LIST_PEOPLE], id);
}

size_t plan_find_route(const Plan *plan, const char *id) {
    return plan_tables_find(plan, &plan_tables_lists[LIST_ROUTES], id);
}

size_t plan_find_door(const Plan *plan, const char *id) {
    return plan_tables_find(plan, &plan_tables_lists[LIST_DOORS], id);
}

size_t plan_find_exit(const Plan *plan, const char *id) {
    return plan_tables_find(plan, &plan_tables_lists[LIST_EXITS], id);
}

const PlanRoute *plan_route_of(const Plan *plan, const char *id) {
    size_t person = plan_find_person(plan, id), route = SIZE_MAX;
    size_t crowd = plan_tables_find(plan, &plan_tables_lists[LIST_CROWDS], id);
    if (person != SIZE_MAX)
        route = plan->people[person].route;
    else if (crowd != SIZE_MAX)
        route = plan->crowds[crowd].route;
    return route == SIZE_MAX ? NULL : &plan->routes[route];
}
