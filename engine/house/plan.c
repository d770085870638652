#include "house/plan.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"

#define NAME(struct_, field_, meaning_)                                                                                \
    { .name = #field_, .kind = PARAMETER_TEXT, .offset = offsetof(struct_, field_), .unit = "", .meaning = meaning_ }
#define ID(struct_, field_, meaning_)                                                                                  \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_ID, .offset = offsetof(struct_, field_), .unit = "", .needed = true,        \
        .meaning = meaning_                                                                                            \
    }
#define NUMBER(struct_, field_, unit_, low_, high_, fallback_, meaning_, provenance_)                                  \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_NUMBER, .offset = offsetof(struct_, field_), .unit = unit_, .low = low_,    \
        .high = high_, .fallback = fallback_, .meaning = meaning_, .provenance = provenance_                           \
    }
#define NEEDED_NUMBER(struct_, field_, unit_, low_, high_, meaning_)                                                   \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_NUMBER, .offset = offsetof(struct_, field_), .unit = unit_, .low = low_,    \
        .high = high_, .needed = true, .meaning = meaning_                                                             \
    }
#define WHOLE(struct_, field_, low_, high_, fallback_, needed_, meaning_, provenance_)                                 \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_WHOLE, .offset = offsetof(struct_, field_), .unit = "1", .low = low_,       \
        .high = high_, .fallback = fallback_, .needed = needed_, .meaning = meaning_, .provenance = provenance_        \
    }
#define CHOICE(struct_, field_, choices_, fallback_, meaning_)                                                         \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_CHOICE, .offset = offsetof(struct_, field_), .unit = "",                    \
        .choices = choices_, .fallback = fallback_, .meaning = meaning_                                                \
    }
#define POINT(struct_, field_, meaning_)                                                                               \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_POINT, .offset = offsetof(struct_, field_), .unit = "m", .needed = true,    \
        .meaning = meaning_                                                                                            \
    }
#define POINTS(struct_, field_, least_, needed_, meaning_)                                                             \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_POINTS, .offset = offsetof(struct_, field_), .unit = "m", .low = least_,    \
        .needed = needed_, .meaning = meaning_                                                                         \
    }

#define FARTHEST PARAMETER_FARTHEST

static const Parameter wall_rows[] = {
    ID(Wall, id, "name of the wall"),
    POINTS(Wall, points, 2, true, "centre line; a closed wall repeats its first point"),
    NUMBER(Wall, thickness, "m", 0, 5, 0.12, "thickness", "assumed: a stud wall with boards"),
    NUMBER(Wall, height, "m", 0, 100, 2.4, "height", "assumed: a usual storey"),
};

static const Parameter door_rows[] = {
    ID(Door, id, "name of the door"),
    ID(Door, wall, "the wall it lies in"),
    WHOLE(Door, segment, 0, 1e6, 0, false, "segment of the wall's points, from 0", "the first"),
    NEEDED_NUMBER(Door, at, "m", 0, FARTHEST, "middle of the door, along its segment"),
    NEEDED_NUMBER(Door, width, "m", 0.01, 100, "clear width"),
    CHOICE(Door, kind, "opening|hinged|sliding", DOOR_OPENING, "what closes it"),
    CHOICE(Door, state, "open|closed|locked", DOOR_OPEN, "how it stands; closed ones cost time, locked ones are wall"),
    CHOICE(Door, hinge, "start|end", HINGE_START, "the end of the segment nearer to the hinge"),
    CHOICE(Door, swing, "left|right", SWING_LEFT, "the side of the wall's direction to which the leaf opens"),
    NUMBER(Door, opening_time, "s", 0, 600, 3, "time to open it when it is closed", "assumed"),
};

static const Parameter furniture_rows[] = {
    ID(Furniture, id, "name for references"),
    NAME(Furniture, name, "name to show"),
    POINT(Furniture, centre, "middle of the footprint as it stands"),
    POINT(Furniture, size, "footprint along its own x and y"),
    NUMBER(Furniture, angle, "degree", -360, 360, 0, "turned counter-clockwise by", "along the axes"),
    NUMBER(Furniture, height, "m", 0, 100, 0.7, "height", "assumed: a table's"),
    CHOICE(Furniture, topples, "front|back|left|right|no", TOPPLE_NO,
           "the face it falls to: front is its own -y, back +y, left -x, right +x"),
    NUMBER(Furniture, probability, "1", 0, 1, 0.5, "probability of toppling in a shake", "assumed"),
    {.name = "toppled",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(Furniture, toppled),
     .unit = "",
     .meaning = "lies on that face already"},
};

static const Parameter room_rows[] = {
    ID(Room, id, "name for references"),
    NAME(Room, name, "name to show"),
    POINTS(Room, outline, 3, true, "outline"),
};

static const Parameter exit_rows[] = {
    ID(Exit, id, "name of the exit"),
    POINT(Exit, from, "one end of the line to cross"),
    POINT(Exit, to, "its other end"),
    NUMBER(Exit, opens, "s", 0, 1e6, 0, "usable from", "from the beginning"),
    NUMBER(Exit, closes, "s", 0, HUGE_VAL, HUGE_VAL, "usable until; absent: always", "always"),
};

static const Parameter person_rows[] = {
    ID(Person, id, "name of the person"),
    ID(Person, profile, "a profile in assets/profiles"),
    POINT(Person, at, "start of the reference point: the drive axle's middle, or a round body's centre"),
    NUMBER(Person, heading, "degree", -360, 360, 0, "heading at the start", "along +x"),
    NUMBER(Person, delay, "s", 0, 1e6, 0, "time before starting", "none"),
    NUMBER(Person, speed, "m/s", 0, 10, 0, "free speed; 0: the profile's mean", "the profile's mean"),
};

static const Parameter crowd_rows[] = {
    ID(Crowd, id, "name of the crowd; its people are NAME-1, NAME-2, ..."),
    ID(Crowd, profile, "a profile in assets/profiles"),
    WHOLE(Crowd, count, 1, 1e5, 1, true, "number of people", ""),
    POINTS(Crowd, area, 3, true, "outline of where they stand, placed by the seed"),
    NUMBER(Crowd, delay, "s", 0, 1e6, 0, "time before starting", "none"),
};

static const Parameter route_rows[] = {
    ID(PlanRoute, id, "name of the route"),
    {.name = "people",
     .kind = PARAMETER_IDS,
     .offset = offsetof(PlanRoute, people),
     .unit = "",
     .needed = true,
     .meaning = "who takes it"},
    POINTS(PlanRoute, via, 0, false, "points to pass within a body's length, in order"),
    {.name = "exit",
     .kind = PARAMETER_ID,
     .offset = offsetof(PlanRoute, exit),
     .unit = "",
     .meaning = "the exit it leads to; absent: the quickest"},
};

static const Parameter observed_rows[] = {
    NEEDED_NUMBER(Observed, mean, "s", 0.001, 1e6, "mean time of the measured runs"),
    NUMBER(Observed, deviation, "s", 0, 1e6, 0, "their standard deviation", "unknown"),
    WHOLE(Observed, runs, 1, 1e6, 1, false, "how many runs", "one"),
};

static const Parameter run_rows[] = {
    NUMBER(RunSettings, dt, "s", 1e-6, 0.1, 0.001, "time step", "chosen: times change by under 0.01 % when halved"),
    NUMBER(RunSettings, until, "s", 0, 1e5, 600, "time to give up at", "chosen"),
    NUMBER(RunSettings, sample, "s", 1e-6, 100, 0.04, "time between two rows of the trace", "chosen: 25 a second"),
    CHOICE(RunSettings, routes, "together|alone", ROUTES_TOGETHER,
           "everybody at once, or each route's people alone, as in an experiment"),
    NUMBER(RunSettings, cell, "m", 0.01, 0.2, 0.05, "cell of the route search", "chosen"),
    WHOLE(RunSettings, reversals, 0, 20, 6, false, "most changes of direction in a drivable route", "assumed"),
    NUMBER(RunSettings, patience, "s", 0.1, 1e4, 20, "time without getting on before a person counts as blocked",
           "assumed"),
    NUMBER(RunSettings, clearance_warning, "m", 0, 2, 0.05, "clearance below which a place is dangerous", "assumed"),
    NUMBER(RunSettings, force_warning, "N", 0, 1e6, 50, "contact force above which a place is dangerous", "assumed"),
    NUMBER(RunSettings, loss_warning, "s", 0, 1e4, 1, "lost time above which a place is a hindrance", "assumed"),
};

#define TABLE(what_, rows_)                                                                                            \
    { what_, rows_, sizeof rows_ / sizeof *rows_ }

static const ParameterTable observed_table = TABLE("observed", observed_rows);
static const ParameterTable run_table = TABLE("run", run_rows);

/* The lists of a plan: one row each, so that reading, writing, `--set` and the schema go through all of them alike. */
typedef struct PlanList {
    const char *key; /* in the file */
    ParameterTable table;
    size_t array, count, size; /* offsets in Plan, bytes of an element; the first field of each is its id */
} PlanList;

#define LIST(key_, what_, rows_, array_, count_, type_)                                                                \
    { key_, TABLE(what_, rows_), offsetof(Plan, array_), offsetof(Plan, count_), sizeof(type_) }

static const PlanList plan_lists[] = {
    LIST("walls", "wall", wall_rows, walls, wall_count, Wall),
    LIST("doors", "door", door_rows, doors, door_count, Door),
    LIST("furniture", "furniture", furniture_rows, furniture, furniture_count, Furniture),
    LIST("rooms", "room", room_rows, rooms, room_count, Room),
    LIST("exits", "exit", exit_rows, exits, exit_count, Exit),
    LIST("people", "person", person_rows, people, person_count, Person),
    LIST("crowds", "crowd", crowd_rows, crowds, crowd_count, Crowd),
    LIST("routes", "route", route_rows, routes, route_count, PlanRoute),
};
enum { PLAN_LISTS = sizeof plan_lists / sizeof *plan_lists, LIST_ROUTES = PLAN_LISTS - 1 };

static const char *const plan_keys[] = {"format", "version",   "name",  "note",      "walls",
                                        "doors",  "furniture", "rooms", "exits",     "people",
                                        "crowds", "routes",    "run",   "overrides", NULL};

static void **list_array(Plan *plan, const PlanList *list) {
    return (void **)((char *)plan + list->array);
}

static size_t *list_count(Plan *plan, const PlanList *list) {
    return (size_t *)((char *)plan + list->count);
}

static void *list_element(const Plan *plan, const PlanList *list, size_t index) {
    char *array = *(char *const *)((const char *)plan + list->array);
    return array + index * list->size;
}

static size_t list_length(const Plan *plan, const PlanList *list) {
    return *(const size_t *)((const char *)plan + list->count);
}

static const char *element_id(const void *element) {
    return *(const char *const *)element;
}

static size_t list_find(const Plan *plan, const PlanList *list, const char *id) {
    for (size_t i = 0; i < list_length(plan, list); i++)
        if (strcmp(element_id(list_element(plan, list, i)), id) == 0)
            return i;
    return SIZE_MAX;
}

/* Reading ---------------------------------------------------------------------------------------------------- */

/* `observed` is an object within a route; the tables know flat fields only. */
static void read_route(PlanRoute *route, const PlanList *list, const JsonNode *node, Arena *arena, Fault *fault) {
    JsonNode observed = json_member(node, "observed");
    JsonNode flat = *node;
    flat.value = json_copy(node->value);
    json_object_del(flat.value, "observed");
    parameters_read(&list->table, route, &flat, arena, fault);
    json_decref(flat.value);
    if (observed.value)
        parameters_read(&observed_table, &route->observed, &observed, arena, fault);
}

static void read_list(Plan *plan, const PlanList *list, const JsonNode *root, Fault *fault) {
    JsonNode node = json_member(root, list->key);
    if (!node.value)
        return;
    if (!json_is_array(node.value)) {
        json_fault(&node, fault, "%s must be a list [ ... ]", list->key);
        return;
    }
    size_t count = json_array_size(node.value);
    *list_array(plan, list) = arena_allocate(&plan->arena, count * list->size);
    *list_count(plan, list) = count;
    for (size_t i = 0; i < count; i++) {
        JsonNode element = json_element(&node, i);
        void *object = list_element(plan, list, i);
        if (list == &plan_lists[LIST_ROUTES])
            read_route(object, list, &element, &plan->arena, fault);
        else
            parameters_read(&list->table, object, &element, &plan->arena, fault);
    }
}

static void read_text_member(const JsonNode *root, const char *key, const char **text, Arena *arena, Fault *fault) {
    JsonNode node = json_member(root, key);
    *text = "";
    if (json_is_string(node.value))
        *text = arena_text(arena, json_string_value(node.value));
    else if (node.value)
        json_fault(&node, fault, "%s must be a text", key);
}

/* One NAME = value: applied to the plan, or kept for the profiles. The node points at the value. */
static void apply_setting(Plan *plan, const char *name, const JsonNode *node, Fault *fault) {
    char kind[32], id[64];
    int used = 0;
    if (sscanf(name, "run.%n", &used) == 0 && used) {
        const Parameter *row = parameters_find(&run_table, name + used);
        if (row)
            parameters_read_value(row, &plan->run, node, &plan->arena, fault);
        else
            parameters_fault_unknown(&run_table, name + used, node, fault);
        return;
    }
    if (sscanf(name, "%31[a-z].%63[A-Za-z0-9_-].%n", kind, id, &used) < 2 || !used || !name[used]) {
        json_fault(node, fault,
                   "\"%.80s\" is no parameter's name: run.NAME, or KIND.ID.NAME such as door.d1.width or "
                   "profile.manual-chair.width",
                   name);
        return;
    }
    if (strcmp(kind, "profile") == 0) {
        Override *kept = arena_allocate(&plan->arena, (plan->override_count + 1) * sizeof *kept);
        if (plan->override_count)
            memcpy(kept, plan->overrides, plan->override_count * sizeof *kept);
        char *value = json_line(node->value);
        Fault place = {0};
        json_fault(node, &place, "%s", "");
        kept[plan->override_count++] = (Override){arena_text(&plan->arena, name), arena_text(&plan->arena, value),
                                                  arena_text(&plan->arena, place.lines[0])};
        fault_clear(&place);
        memory_free(value);
        plan->overrides = kept;
        return;
    }
    const char *kinds[PLAN_LISTS + 2] = {"profile", "run"};
    for (size_t l = 0; l < PLAN_LISTS; l++) {
        const PlanList *list = &plan_lists[l];
        kinds[l + 2] = list->table.what;
        if (strcmp(list->table.what, kind) != 0)
            continue;
        size_t index = list_find(plan, list, id);
        const Parameter *row = parameters_find(&list->table, name + used);
        if (index == SIZE_MAX)
            json_fault(node, fault, "there is no %s \"%s\"", kind, id);
        else if (!row)
            parameters_fault_unknown(&list->table, name + used, node, fault);
        else
            parameters_read_value(row, list_element(plan, list, index), node, &plan->arena, fault);
        return;
    }
    const char *nearest = text_nearest(kind, kinds, PLAN_LISTS + 2);
    json_fault(node, fault, "unknown kind \"%s\"%s%s%s", kind,
               nearest ? ", did you mean \"" : ", known are wall, door, ",
               nearest ? nearest : "furniture, room, exit, person, crowd, route, profile, run", nearest ? "\"?" : "");
}

static void read_overrides(Plan *plan, const JsonNode *root, Fault *fault) {
    JsonNode node = json_member(root, "overrides");
    if (node.value && !json_is_object(node.value)) {
        json_fault(&node, fault, "overrides must be an object { \"NAME\": value }");
        return;
    }
    const char *key;
    json_t *value;
    json_object_foreach(node.value, key, value) {
        JsonNode member = json_member(&node, key);
        apply_setting(plan, key, &member, fault);
    }
}

/* A NAME=VALUE of the command line, read as if VALUE were a file of its own: a number, a list, or else a word. */
static void read_setting(Plan *plan, const char *setting, Fault *fault) {
    const char *equals = strchr(setting, '=');
    if (!equals || equals == setting || !equals[1]) {
        fault_add(fault, "--set %.80s: must be NAME=VALUE, for instance door.d1.width=0.8", setting);
        return;
    }
    char name[160], path[180];
    snprintf(name, sizeof name, "%.*s", (int)(equals - setting < 150 ? equals - setting : 150), setting);
    snprintf(path, sizeof path, "--set %s", name);
    JsonFile file = {.path = path, .text = (char *)(uintptr_t)(equals + 1)};
    file.root = json_loads(equals + 1, JSON_DECODE_ANY, NULL);
    if (!file.root)
        file.root = json_string(equals + 1);
    if (!file.root) {
        fault_add(fault, "%s: the value is not UTF-8", path);
        return;
    }
    JsonNode node = json_root(&file);
    apply_setting(plan, name, &node, fault);
    json_decref(file.root);
}

/* Checking what the tables cannot: references and geometry ----------------------------------------------------- */

typedef struct Check {
    const Plan *plan;
    const JsonNode *root;
    Fault *fault;
} Check;

/* Adds a fault at member `key` (or the whole element when it has none) of element `index` of a list. */
static void check_fault(const Check *check, const char *list, size_t index, const char *key, const char *what) {
    JsonNode array = json_member(check->root, list);
    JsonNode element = json_element(&array, index);
    JsonNode member = json_member(&element, key);
    json_fault(member.value ? &member : &element, check->fault, "%s", what);
}

typedef struct IdPlace {
    const char *id;
    const PlanList *list;
    size_t index;
} IdPlace;

static int compare_ids(const void *a, const void *b) {
    const IdPlace *p = a, *q = b;
    int order = strcmp(p->id, q->id);
    if (order)
        return order;
    if (p->list != q->list)
        return p->list < q->list ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

static void check_unique_ids(const Check *check) {
    size_t count = 0, used = 0;
    for (size_t l = 0; l < PLAN_LISTS; l++)
        count += list_length(check->plan, &plan_lists[l]);
    IdPlace *places = memory_allocate(count, sizeof *places);
    for (size_t l = 0; l < PLAN_LISTS; l++)
        for (size_t i = 0; i < list_length(check->plan, &plan_lists[l]); i++)
            places[used++] = (IdPlace){element_id(list_element(check->plan, &plan_lists[l], i)), &plan_lists[l], i};
    qsort(places, count, sizeof *places, compare_ids);
    for (size_t i = 1; i < count; i++) {
        if (*places[i].id && strcmp(places[i].id, places[i - 1].id) == 0) {
            char what[160];
            snprintf(what, sizeof what, "id \"%.60s\" is used twice, first by a %s; ids must differ", places[i].id,
                     places[i - 1].list->table.what);
            check_fault(check, places[i].list->key, places[i].index, "id", what);
        }
    }
    memory_free(places);
}

static void check_walls(const Check *check) {
    for (size_t w = 0; w < check->plan->wall_count; w++) {
        const Wall *wall = &check->plan->walls[w];
        for (size_t i = 1; i < wall->points.count; i++) {
            if (vec2_distance(wall->points.at[i - 1], wall->points.at[i]) < 1e-6) {
                char what[160];
                snprintf(what, sizeof what, "wall %.40s: points %zu and %zu are the same, must be apart", wall->id,
                         i - 1, i);
                check_fault(check, "walls", w, "points", what);
                break;
            }
        }
    }
}

static void check_door(const Check *check, size_t d) {
    Door *door = &((Plan *)(uintptr_t)check->plan)->doors[d];
    char what[240];
    door->wall_index = list_find(check->plan, &plan_lists[0], door->wall);
    if (door->wall_index == SIZE_MAX) {
        snprintf(what, sizeof what, "door %.40s: there is no wall \"%.40s\"", door->id, door->wall);
        check_fault(check, "doors", d, "wall", what);
        return;
    }
    const Wall *wall = &check->plan->walls[door->wall_index];
    if ((size_t)door->segment + 1 >= wall->points.count) {
        snprintf(what, sizeof what, "door %.40s: segment %d, but wall %.40s has segments 0 to %zu", door->id,
                 door->segment, wall->id, wall->points.count - 2);
        check_fault(check, "doors", d, "segment", what);
        return;
    }
    double length = vec2_distance(wall->points.at[door->segment], wall->points.at[door->segment + 1]);
    const double rounding = 1e-9; /* m: a door may fill its wall to the last bit */
    if (door->width > length + rounding) {
        snprintf(what, sizeof what, "door %.40s: width %g m, at most wall %.40s's %.2f m", door->id, door->width,
                 wall->id, length);
        check_fault(check, "doors", d, "width", what);
    } else if (door->at - door->width / 2 < -rounding || door->at + door->width / 2 > length + rounding) {
        snprintf(what, sizeof what, "door %.40s: at %g m is past the end of wall %.40s, must be from %.3g to %.3g m",
                 door->id, door->at, wall->id, door->width / 2, length - door->width / 2);
        check_fault(check, "doors", d, "at", what);
    }
    for (size_t e = 0; e < d; e++) {
        const Door *other = &check->plan->doors[e];
        if (other->wall_index == door->wall_index && other->segment == door->segment &&
            fabs(other->at - door->at) < (other->width + door->width) / 2 - rounding) {
            snprintf(what, sizeof what, "door %.40s overlaps door %.40s in wall %.40s", door->id, other->id, wall->id);
            check_fault(check, "doors", d, "at", what);
        }
    }
}

static bool inside_corners(Vec2 p, const Vec2 *corners, size_t count) {
    bool inside = true;
    for (size_t i = 0; i < count; i++) {
        Vec2 edge = vec2_sub(corners[(i + 1) % count], corners[i]);
        inside &= vec2_cross(edge, vec2_sub(p, corners[i])) > 0;
    }
    return inside;
}

/* The id of the wall or furniture that the point is inside of, or NULL. */
static const char *solid_at(const Plan *plan, Vec2 p) {
    for (size_t f = 0; f < plan->furniture_count; f++) {
        Vec2 corners[4];
        plan_furniture_corners(&plan->furniture[f], corners);
        if (inside_corners(p, corners, 4))
            return plan->furniture[f].id;
    }
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        for (size_t s = 0; s + 1 < wall->points.count; s++) {
            Vec2 a = wall->points.at[s], b = wall->points.at[s + 1];
            if (vec2_distance(p, vec2_nearest_on_segment(p, a, b)) >= wall->thickness / 2)
                continue;
            double along = vec2_dot(vec2_sub(p, a), vec2_unit(vec2_sub(b, a)));
            bool in_door = false;
            for (size_t d = 0; d < plan->door_count && !in_door; d++) {
                const Door *door = &plan->doors[d];
                in_door = door->wall_index == w && (size_t)door->segment == s && door->state != DOOR_LOCKED &&
                          fabs(along - door->at) < door->width / 2;
            }
            if (!in_door)
                return wall->id;
        }
    }
    return NULL;
}

static void check_people(const Check *check) {
    const Plan *plan = check->plan;
    for (size_t p = 0; p < plan->person_count; p++) {
        const char *solid = solid_at(plan, plan->people[p].at);
        if (solid) {
            char what[200];
            snprintf(what, sizeof what, "person %.40s stands inside %.40s, must stand in free space",
                     plan->people[p].id, solid);
            check_fault(check, "people", p, "at", what);
        }
    }
}

static void check_route(const Check *check, size_t r) {
    PlanRoute *route = &((Plan *)(uintptr_t)check->plan)->routes[r];
    char what[200];
    route->exit_index = SIZE_MAX;
    if (*route->exit) {
        for (size_t e = 0; e < check->plan->exit_count; e++)
            if (strcmp(check->plan->exits[e].id, route->exit) == 0)
                route->exit_index = e;
        if (route->exit_index == SIZE_MAX) {
            snprintf(what, sizeof what, "route %.40s: there is no exit \"%.40s\"", route->id, route->exit);
            check_fault(check, "routes", r, "exit", what);
        }
    }
    for (size_t i = 0; i < route->people.count; i++) {
        const char *id = route->people.at[i];
        if (plan_find_person(check->plan, id) == SIZE_MAX) {
            snprintf(what, sizeof what, "route %.40s: there is no person \"%.40s\"", route->id, id);
            check_fault(check, "routes", r, "people", what);
        }
        for (size_t q = 0; q < r; q++)
            for (size_t k = 0; k < check->plan->routes[q].people.count; k++)
                if (strcmp(check->plan->routes[q].people.at[k], id) == 0) {
                    snprintf(what, sizeof what, "route %.40s: person %.40s already takes route %.40s", route->id, id,
                             check->plan->routes[q].id);
                    check_fault(check, "routes", r, "people", what);
                }
    }
}

static void check_plan(const Check *check) {
    const Plan *plan = check->plan;
    check_unique_ids(check);
    check_walls(check);
    for (size_t d = 0; d < plan->door_count; d++)
        check_door(check, d);
    for (size_t f = 0; f < plan->furniture_count; f++) {
        const Furniture *piece = &plan->furniture[f];
        if (!(piece->size.x >= 0.01 && piece->size.y >= 0.01))
            check_fault(check, "furniture", f, "size", "size must be at least 0.01 m in both directions");
        if (piece->toppled && piece->topples == TOPPLE_NO)
            check_fault(check, "furniture", f, "toppled", "toppled, but topples to no face: set \"topples\"");
    }
    for (size_t e = 0; e < plan->exit_count; e++) {
        if (vec2_distance(plan->exits[e].from, plan->exits[e].to) < 0.01)
            check_fault(check, "exits", e, "to", "an exit's ends must be at least 0.01 m apart");
        if (plan->exits[e].closes <= plan->exits[e].opens)
            check_fault(check, "exits", e, "closes", "closes before it opens, must close later");
    }
    if (!check->fault->count) /* needs sound walls and doors */
        check_people(check);
    for (size_t r = 0; r < plan->route_count; r++)
        check_route(check, r);
    if (plan->run.sample < plan->run.dt) {
        JsonNode run = json_member(check->root, "run");
        json_fault(run.value ? &run : check->root, check->fault, "sample is %g s, must be at least the step dt, %g s",
                   plan->run.sample, plan->run.dt);
    }
}

static void read_header(const JsonNode *root, Fault *fault) {
    JsonNode format = json_member(root, "format"), version = json_member(root, "version");
    const char *word = json_string_value(format.value);
    if (!word || strcmp(word, "clearance-house") != 0)
        json_fault(format.value ? &format : root, fault, "format must be \"clearance-house\"");
    if (!json_is_integer(version.value) || json_integer_value(version.value) != 1)
        json_fault(version.value ? &version : root, fault, "version must be 1");
    if (!json_object_get(root->value, "walls"))
        json_fault(root, fault, "a house has no \"walls\"");
}

bool plan_read(Plan *plan, const char *path, const char *const *settings, size_t setting_count, Fault *fault) {
    size_t before = fault->count;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Plan read = {0};
    JsonNode root = json_root(&file);
    if (!json_is_object(root.value)) {
        json_fault(&root, fault, "a house must be an object { ... }");
    } else {
        read_header(&root, fault);
        json_check_keys(&root, plan_keys, fault);
        read_text_member(&root, "name", &read.name, &read.arena, fault);
        read_text_member(&root, "note", &read.note, &read.arena, fault);
        for (size_t l = 0; l < PLAN_LISTS; l++)
            read_list(&read, &plan_lists[l], &root, fault);
        JsonNode run = json_member(&root, "run");
        if (run.value)
            parameters_read(&run_table, &read.run, &run, &read.arena, fault);
        else
            parameters_reset(&run_table, &read.run);
        if (fault->count == before)
            read_overrides(&read, &root, fault);
        for (size_t i = 0; i < setting_count && fault->count == before; i++)
            read_setting(&read, settings[i], fault);
        if (fault->count == before)
            check_plan(&(Check){&read, &root, fault});
    }
    json_free(&file);
    if (fault->count != before) {
        plan_free(&read);
        return false;
    }
    plan_free(plan);
    *plan = read;
    return true;
}

void plan_free(Plan *plan) {
    arena_clear(&plan->arena);
    *plan = (Plan){0};
}

/* Writing: one element a line --------------------------------------------------------------------------------- */

typedef struct Lines {
    char *text;
    size_t used, capacity;
} Lines;

static void lines_add(Lines *lines, const char *text) {
    size_t length = strlen(text);
    lines->text = memory_reserve(lines->text, &lines->capacity, lines->used + length + 1, 1);
    memcpy(lines->text + lines->used, text, length + 1);
    lines->used += length;
}

static void lines_add_json(Lines *lines, json_t *value) {
    char *line = json_line(value);
    lines_add(lines, line);
    memory_free(line);
    json_decref(value);
}

static void lines_add_list(Lines *lines, const Plan *plan, const PlanList *list) {
    size_t count = list_length(plan, list);
    lines_add(lines, ",\n  \"");
    lines_add(lines, list->key);
    lines_add(lines, "\": [");
    for (size_t i = 0; i < count; i++) {
        const void *element = list_element(plan, list, i);
        json_t *written = parameters_write(&list->table, element);
        if (list == &plan_lists[LIST_ROUTES] && ((const PlanRoute *)element)->observed.mean > 0)
            json_object_set_new(written, "observed",
                                parameters_write(&observed_table, &((const PlanRoute *)element)->observed));
        lines_add(lines, i ? ",\n    " : "\n    ");
        lines_add_json(lines, written);
    }
    lines_add(lines, count ? "\n  ]" : "]");
}

int plan_write(const Plan *plan, const char *path) {
    Lines lines = {0};
    lines_add(&lines, "{\n  \"format\": \"clearance-house\", \"version\": 1,\n  \"name\": ");
    lines_add_json(&lines, json_string(plan->name));
    lines_add(&lines, ",\n  \"note\": ");
    lines_add_json(&lines, json_string(plan->note));
    for (size_t l = 0; l < PLAN_LISTS; l++)
        if (l == 0 || list_length(plan, &plan_lists[l]))
            lines_add_list(&lines, plan, &plan_lists[l]);
    json_t *run = parameters_write(&run_table, &plan->run);
    if (json_object_size(run)) {
        lines_add(&lines, ",\n  \"run\": ");
        lines_add_json(&lines, json_incref(run));
    }
    json_decref(run);
    if (plan->override_count) {
        json_t *overrides = json_object();
        for (size_t i = 0; i < plan->override_count; i++)
            json_object_set_new(overrides, plan->overrides[i].name,
                                json_loads(plan->overrides[i].value, JSON_DECODE_ANY, NULL));
        lines_add(&lines, ",\n  \"overrides\": ");
        lines_add_json(&lines, overrides);
    }
    lines_add(&lines, "\n}\n");
    int error = text_write_file(path, lines.text, lines.used);
    memory_free(lines.text);
    return error;
}

/* Schema ------------------------------------------------------------------------------------------------------ */

json_t *plan_schema(void) {
    json_t *properties = json_object();
    json_object_set_new(properties, "format", json_pack("{s:s}", "const", "clearance-house"));
    json_object_set_new(properties, "version", json_pack("{s:i}", "const", 1));
    json_object_set_new(properties, "name", json_pack("{s:s, s:s}", "type", "string", "description", "name to show"));
    json_object_set_new(
        properties, "note",
        json_pack("{s:s, s:s}", "type", "string", "description", "where the plan comes from, what is assumed"));
    for (size_t l = 0; l < PLAN_LISTS; l++) {
        json_t *element = parameters_schema(&plan_lists[l].table);
        if (l == LIST_ROUTES)
            json_object_set_new(json_object_get(element, "properties"), "observed", parameters_schema(&observed_table));
        json_object_set_new(properties, plan_lists[l].key, json_pack("{s:s, s:o}", "type", "array", "items", element));
    }
    json_object_set_new(properties, "run", parameters_schema(&run_table));
    json_object_set_new(properties, "overrides",
                        json_pack("{s:s, s:s}", "type", "object", "description",
                                  "parameters by their path, for instance profile.manual-chair.width"));
    return json_pack("{s:s, s:s, s:s, s:b, s:o, s:[s,s,s]}", "$schema", "https://json-schema.org/draft/2020-12/schema",
                     "title", "A house of clearance", "type", "object", "additionalProperties", 0, "properties",
                     properties, "required", "format", "version", "walls");
}

/* Geometry and look-ups --------------------------------------------------------------------------------------- */

void plan_door_ends(const Plan *plan, const Door *door, Vec2 *from, Vec2 *to) {
    const Vec2 *points = plan->walls[door->wall_index].points.at + door->segment;
    Vec2 along = vec2_unit(vec2_sub(points[1], points[0]));
    *from = vec2_along(points[0], door->at - door->width / 2, along);
    *to = vec2_along(points[0], door->at + door->width / 2, along);
}

void plan_furniture_corners(const Furniture *piece, Vec2 corners[4]) {
    double left = -piece->size.x / 2, right = -left, front = -piece->size.y / 2, back = -front;
    if (piece->toppled) {
        left -= piece->topples == TOPPLE_LEFT ? piece->height : 0;
        right += piece->topples == TOPPLE_RIGHT ? piece->height : 0;
        front -= piece->topples == TOPPLE_FRONT ? piece->height : 0;
        back += piece->topples == TOPPLE_BACK ? piece->height : 0;
    }
    Vec2 axis = vec2_heading(radians(piece->angle));
    Vec2 own[4] = {{left, front}, {right, front}, {right, back}, {left, back}};
    for (int i = 0; i < 4; i++)
        corners[i] = vec2_add(piece->centre, vec2_turn(own[i], axis));
}

size_t plan_find_person(const Plan *plan, const char *id) {
    for (size_t i = 0; i < plan->person_count; i++)
        if (strcmp(plan->people[i].id, id) == 0)
            return i;
    return SIZE_MAX;
}

size_t plan_find_route(const Plan *plan, const char *id) {
    return list_find(plan, &plan_lists[LIST_ROUTES], id);
}

const PlanRoute *plan_route_of(const Plan *plan, const char *person) {
    for (size_t r = 0; r < plan->route_count; r++)
        for (size_t i = 0; i < plan->routes[r].people.count; i++)
            if (strcmp(plan->routes[r].people.at[i], person) == 0)
                return &plan->routes[r];
    return NULL;
}
