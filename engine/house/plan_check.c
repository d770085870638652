#include "house/plan_check.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double ROUNDING = 1e-9;        /* m: a door may fill its wall to the last bit */
static const double WALL_SHORTEST = 1e-6;   /* m, of a segment: what the outline's grid still resolves */
static const double EXIT_SHORTEST = 0.01;   /* m */
static const double FURNITURE_LEAST = 0.01; /* m, in both directions */

static bool is_sound(const PlanCheck *check, int list, size_t index) {
    return check->sound[list][index];
}

static bool all_sound(const PlanCheck *check, int list) {
    for (size_t i = 0; i < plan_tables_count(check->plan, &plan_tables_lists[list]); i++)
        if (!is_sound(check, list, i))
            return false;
    return true;
}

/* Adds a fault at member `key` (or the whole element when it has none) of element `index` of a list. */
__attribute__((format(printf, 5, 6))) static void add_fault(const PlanCheck *check, int list, size_t index,
                                                            const char *key, const char *format, ...) {
    char what[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    JsonNode array = json_member(check->root, plan_tables_lists[list].key);
    JsonNode element = json_element(&array, index);
    JsonNode member = json_member(&element, key);
    json_fault(member.value ? &member : &element, check->fault, "%s", what);
}

/* Ids --------------------------------------------------------------------------------------------------------- */

typedef struct IdPlace {
    const char *id;
    int list;
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

static void check_unique_ids(const PlanCheck *check) {
    size_t count = 0, used = 0;
    for (int l = 0; l < PLAN_LISTS; l++)
        count += plan_tables_count(check->plan, &plan_tables_lists[l]);
    IdPlace *places = memory_allocate(count, sizeof *places);
    for (int l = 0; l < PLAN_LISTS; l++)
        for (size_t i = 0; i < plan_tables_count(check->plan, &plan_tables_lists[l]); i++)
            places[used++] = (IdPlace){plan_tables_id(check->plan, &plan_tables_lists[l], i), l, i};
    qsort(places, count, sizeof *places, compare_ids);
    for (size_t i = 1; i < count; i++)
        if (*places[i].id && strcmp(places[i].id, places[i - 1].id) == 0)
            add_fault(check, places[i].list, places[i].index, "id",
                      "id \"%.60s\" is used twice, first by a %s; ids must differ", places[i].id,
                      plan_tables_lists[places[i - 1].list].table.what);
    memory_free(places);
}

/* Walls, doors, furniture, exits ------------------------------------------------------------------------------- */

static void check_wall(const PlanCheck *check, size_t w) {
    const Wall *wall = &check->plan->walls[w];
    for (size_t i = 1; i < wall->points.count; i++) {
        if (vec2_distance(wall->points.at[i - 1], wall->points.at[i]) < WALL_SHORTEST) {
            add_fault(check, LIST_WALLS, w, "points", "wall %.40s: points %zu and %zu are the same, must be apart",
                      wall->id, i, i + 1);
            break;
        }
    }
}

static void check_overlaps(const PlanCheck *check, size_t d) {
    const Door *door = &check->plan->doors[d];
    for (size_t e = 0; e < d; e++) {
        const Door *other = &check->plan->doors[e];
        if (is_sound(check, LIST_DOORS, e) && other->wall_index == door->wall_index &&
            other->segment == door->segment && fabs(other->at - door->at) < (other->width + door->width) / 2 - ROUNDING)
            add_fault(check, LIST_DOORS, d, "at", "door %.40s overlaps door %.40s, must be at least %.3g m from it",
                      door->id, other->id, (other->width + door->width) / 2);
    }
}

static void check_door(const PlanCheck *check, size_t d) {
    Door *door = &check->plan->doors[d];
    door->wall_index = plan_tables_find(check->plan, &plan_tables_lists[LIST_WALLS], door->wall);
    if (door->wall_index == SIZE_MAX) {
        add_fault(check, LIST_DOORS, d, "wall", "door %.40s: there is no wall \"%.40s\"", door->id, door->wall);
        return;
    }
    if (!is_sound(check, LIST_WALLS, door->wall_index))
        return;
    const Wall *wall = &check->plan->walls[door->wall_index];
    size_t last = wall->points.count - 2;
    if ((size_t)door->segment > last) {
        add_fault(check, LIST_DOORS, d, "segment", "door %.40s: segment is %d, must be from 0 to %zu in wall %.40s",
                  door->id, door->segment, last, wall->id);
        return;
    }
    double length = vec2_distance(wall->points.at[door->segment], wall->points.at[door->segment + 1]);
    if (door->width > length + ROUNDING)
        add_fault(check, LIST_DOORS, d, "width", "door %.40s: width is %g m, must be at most %.4g m in wall %.40s",
                  door->id, door->width, length, wall->id);
    else if (door->at - door->width / 2 < -ROUNDING || door->at + door->width / 2 > length + ROUNDING)
        add_fault(check, LIST_DOORS, d, "at",
                  "door %.40s: at is %g m, past the end of wall %.40s, must be from %.4g to %.4g m", door->id, door->at,
                  wall->id, door->width / 2, length - door->width / 2);
    else
        check_overlaps(check, d);
}

static void check_piece(const PlanCheck *check, size_t f) {
    const Furniture *piece = &check->plan->furniture[f];
    if (!(piece->size.x >= FURNITURE_LEAST && piece->size.y >= FURNITURE_LEAST))
        add_fault(check, LIST_FURNITURE, f, "size",
                  "furniture %.40s: size is (%g, %g), must be at least %g m in both directions", piece->id,
                  piece->size.x, piece->size.y, FURNITURE_LEAST);
    if (piece->toppled && piece->topples == TOPPLE_NO)
        add_fault(check, LIST_FURNITURE, f, "toppled",
                  "furniture %.40s is toppled, \"topples\" must say on which face it lies", piece->id);
}

static void check_exit(const PlanCheck *check, size_t e) {
    const Exit *exit = &check->plan->exits[e];
    if (vec2_distance(exit->from, exit->to) < EXIT_SHORTEST)
        add_fault(check, LIST_EXITS, e, "to", "exit %.40s: from and to must be at least %g m apart", exit->id,
                  EXIT_SHORTEST);
    if (exit->closes <= exit->opens)
        add_fault(check, LIST_EXITS, e, "closes", "exit %.40s: closes is %g s, must be later than it opens, at %g s",
                  exit->id, exit->closes, exit->opens);
}

/* People and routes -------------------------------------------------------------------------------------------- */

static bool inside_corners(Vec2 p, const Vec2 *corners, size_t count) {
    bool inside = true;
    for (size_t i = 0; i < count; i++) {
        Vec2 edge = vec2_sub(corners[(i + 1) % count], corners[i]);
        inside &= vec2_cross(edge, vec2_sub(p, corners[i])) > 0;
    }
    return inside;
}

static bool in_doorway(const Plan *plan, size_t wall, size_t segment, double along) {
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        if (door->wall_index == wall && (size_t)door->segment == segment && door->state != DOOR_LOCKED &&
            fabs(along - door->at) < door->width / 2)
            return true;
    }
    return false;
}

/* Names what the point is inside of, "wall w1", "furniture f1" or "wardrobe (f1)"; false: it is in free space. */
static bool solid_at(const Plan *plan, Vec2 p, char *name, size_t size) {
    for (size_t f = 0; f < plan->furniture_count; f++) {
        const Furniture *piece = &plan->furniture[f];
        Vec2 corners[4];
        plan_furniture_corners(piece, corners);
        if (inside_corners(p, corners, 4)) {
            if (!*piece->name || strcmp(piece->name, piece->id) == 0)
                snprintf(name, size, "furniture %.40s", piece->id);
            else
                snprintf(name, size, "%.40s (%.40s)", piece->name, piece->id);
            return true;
        }
    }
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        for (size_t s = 0; s + 1 < wall->points.count; s++) {
            Vec2 a = wall->points.at[s], b = wall->points.at[s + 1];
            if (vec2_distance(p, vec2_nearest_on_segment(p, a, b)) < wall->thickness / 2 &&
                !in_doorway(plan, w, s, vec2_dot(vec2_sub(p, a), vec2_unit(vec2_sub(b, a))))) {
                snprintf(name, size, "wall %.40s", wall->id);
                return true;
            }
        }
    }
    return false;
}

static void check_person(const PlanCheck *check, size_t p) {
    const Person *person = &check->plan->people[p];
    char solid[100];
    if (solid_at(check->plan, person->at, solid, sizeof solid))
        add_fault(check, LIST_PEOPLE, p, "at", "person %.40s stands inside %s, must stand in free space", person->id,
                  solid);
}

/* The route that lists the person before `place` in route `r`, or NULL. */
static const PlanRoute *earlier_route(const Plan *plan, size_t r, size_t place, const char *person) {
    for (size_t q = 0; q <= r; q++) {
        const Ids *people = &plan->routes[q].people;
        for (size_t i = 0; i < (q < r ? people->count : place); i++)
            if (people->at[i] && strcmp(people->at[i], person) == 0)
                return &plan->routes[q];
    }
    return NULL;
}

static void check_route(const PlanCheck *check, size_t r) {
    const Plan *plan = check->plan;
    PlanRoute *route = &check->plan->routes[r];
    route->exit_index = SIZE_MAX;
    if (*route->exit) {
        route->exit_index = plan_tables_find(plan, &plan_tables_lists[LIST_EXITS], route->exit);
        if (route->exit_index == SIZE_MAX)
            add_fault(check, LIST_ROUTES, r, "exit", "route %.40s: there is no exit \"%.40s\"", route->id, route->exit);
    }
    for (size_t i = 0; i < route->people.count; i++) {
        const char *id = route->people.at[i];
        const PlanRoute *earlier = earlier_route(plan, r, i, id);
        if (plan_find_person(plan, id) == SIZE_MAX &&
            plan_tables_find(plan, &plan_tables_lists[LIST_CROWDS], id) == SIZE_MAX)
            add_fault(check, LIST_ROUTES, r, "people", "route %.40s: there is no person or crowd \"%.40s\"", route->id,
                      id);
        else if (earlier)
            add_fault(check, LIST_ROUTES, r, "people",
                      "route %.40s: person %.40s already takes route %.40s, must take one only", route->id, id,
                      earlier->id);
    }
}

static void check_each(const PlanCheck *check, int list, void (*check_element)(const PlanCheck *check, size_t index)) {
    for (size_t i = 0; i < plan_tables_count(check->plan, &plan_tables_lists[list]); i++)
        if (is_sound(check, list, i))
            check_element(check, i);
}

void plan_check_whole(const PlanCheck *check) {
    check_unique_ids(check);
    size_t before = check->fault->total;
    check_each(check, LIST_WALLS, check_wall);
    check_each(check, LIST_DOORS, check_door);
    check_each(check, LIST_FURNITURE, check_piece);
    bool solid = check->fault->total == before && all_sound(check, LIST_WALLS) && all_sound(check, LIST_DOORS) &&
                 all_sound(check, LIST_FURNITURE);
    check_each(check, LIST_EXITS, check_exit);
    if (solid)
        check_each(check, LIST_PEOPLE, check_person);
    check_each(check, LIST_ROUTES, check_route);
    const RunSettings *run = &check->plan->run;
    if (run->sample < run->dt) {
        JsonNode node = json_member(check->root, "run");
        JsonNode sample = json_member(&node, "sample");
        json_fault(sample.value ? &sample
                   : node.value ? &node
                                : check->root,
                   check->fault, "sample is %g s, must be at least the step dt, %g s", run->sample, run->dt);
    }
}
