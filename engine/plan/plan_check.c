#include "plan/plan_check.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mechanics/broadphase.h"
#include "plan/observed_times.h"
#include "plan/plan_geometry.h"

static const double ROUNDING = 1e-9;        /* m: tolerance for a door that fills its wall exactly */
static const double WALL_SHORTEST = 1e-6;   /* m, of a segment: the resolution of the outline's grid */
static const double GAP_LEAST = 0.01;       /* m, that the open leaf of a sliding door leaves free, at least */
static const double EXIT_SHORTEST = 0.01;   /* m */
static const double FURNITURE_LEAST = 0.01; /* m, in both directions */
static const double MOST_PEOPLE = 2e5;      /* 1: a house of some 200 MB, and minutes to place */

static bool is_sound(const PlanCheck *check, int list, size_t index) {
    return check->sound[list][index];
}

static bool all_sound(const PlanCheck *check, int list) {
    for (size_t i = 0; i < plan_tables_count(check->plan, &plan_tables_lists[list]); i++)
        if (!is_sound(check, list, i))
            return false;
    return true;
}

/* Adds an error at member `key` (or the whole element when it has none) of element `index` of a list. */
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
    IdPlace *places = memory_zeroed(count, sizeof *places);
    for (int l = 0; l < PLAN_LISTS; l++)
        for (size_t i = 0; i < plan_tables_count(check->plan, &plan_tables_lists[l]); i++)
            places[used++] = (IdPlace){plan_tables_id(check->plan, &plan_tables_lists[l], i), l, i};
    qsort(places, count, sizeof *places, compare_ids);
    for (size_t i = 1; i < count; i++)
        if (*places[i].id && strcmp(places[i].id, places[i - 1].id) == 0)
            add_fault(check, places[i].list, places[i].index, "id",
                      "id \"%.60s\" is used twice, first by a %s; ids must be unique", places[i].id,
                      plan_tables_lists[places[i - 1].list].table.what);
    memory_free(places);
}

/* Walls, doors, furniture, exits ------------------------------------------------------------------------------- */

static void check_wall(const PlanCheck *check, size_t w) {
    const Wall *wall = &check->plan->walls[w];
    for (size_t i = 1; i < wall->points.count; i++) {
        if (vec2_distance(wall->points.at[i - 1], wall->points.at[i]) < WALL_SHORTEST) {
            add_fault(check, LIST_WALLS, w, "points", "wall %.40s: points %zu and %zu coincide; they must be apart",
                      wall->id, i, i + 1);
            break;
        }
    }
}

/* Doors ordered by wall, segment and beginning. */
typedef struct Doorway {
    size_t wall, segment, door;
    double from, to; /* m, along the segment */
} Doorway;

static int compare_doorways(const void *a, const void *b) {
    const Doorway *p = a, *q = b;
    if (p->wall != q->wall)
        return p->wall < q->wall ? -1 : 1;
    if (p->segment != q->segment)
        return p->segment < q->segment ? -1 : 1;
    if (p->from != q->from)
        return p->from < q->from ? -1 : 1;
    return p->door < q->door ? -1 : p->door > q->door;
}

static bool same_segment(const Doorway *a, const Doorway *b) {
    return a->wall == b->wall && a->segment == b->segment;
}

/* Checks each door against the one before it that reaches farthest. */
static void check_overlaps(const PlanCheck *check, const Doorway *doorways, size_t count) {
    const Doorway *farthest = doorways;
    for (size_t i = 1; i < count; i++) {
        const Doorway *here = &doorways[i];
        if (same_segment(here, farthest) && here->from < farthest->to - ROUNDING) {
            size_t later = here->door > farthest->door ? here->door : farthest->door;
            const Door *door = &check->plan->doors[later];
            const Door *other = &check->plan->doors[later == here->door ? farthest->door : here->door];
            add_fault(check, LIST_DOORS, later, "at", "door %.40s overlaps door %.40s, must be at least %.3g m from it",
                      door->id, other->id, (other->width + door->width) / 2);
        }
        if (!same_segment(here, farthest) || here->to > farthest->to)
            farthest = here;
    }
}

/* Checks that a door lies in its wall. Otherwise adds an error, of the door or of the wall. */
static bool check_door(const PlanCheck *check, size_t d) {
    Door *door = &check->plan->doors[d];
    door->wall_index = plan_tables_find(check->plan, &plan_tables_lists[LIST_WALLS], door->wall);
    if (door->wall_index == SIZE_MAX) {
        add_fault(check, LIST_DOORS, d, "wall", "door %.40s: there is no wall \"%.40s\"", door->id, door->wall);
        return false;
    }
    if (!is_sound(check, LIST_WALLS, door->wall_index))
        return false;
    const Wall *wall = &check->plan->walls[door->wall_index];
    size_t last = wall->points.count - 2;
    if ((size_t)door->segment > last) {
        add_fault(check, LIST_DOORS, d, "segment", "door %.40s: segment is %d, must be from 0 to %zu in wall %.40s",
                  door->id, door->segment, last, wall->id);
        return false;
    }
    double length = vec2_distance(wall->points.at[door->segment], wall->points.at[door->segment + 1]);
    if (door->width > length + ROUNDING) {
        add_fault(check, LIST_DOORS, d, "width", "door %.40s: width is %g m, must be at most %.4g m in wall %.40s",
                  door->id, door->width, length, wall->id);
        return false;
    }
    if (door->at - door->width / 2 < -ROUNDING || door->at + door->width / 2 > length + ROUNDING) {
        add_fault(check, LIST_DOORS, d, "at",
                  "door %.40s: at is %g m, past the end of wall %.40s, must be from %.4g to %.4g m", door->id, door->at,
                  wall->id, door->width / 2, length - door->width / 2);
        return false;
    }
    if (door->rest > door->width - GAP_LEAST) {
        add_fault(check, LIST_DOORS, d, "rest",
                  "door %.40s: rest is %g m, must be at least %g m less than the width, %g m", door->id, door->rest,
                  GAP_LEAST, door->width);
        return false;
    }
    return true;
}

/* Returns the doors that lie in their walls, in order (count); memory_free them. */
static Doorway *check_doors(const PlanCheck *check, size_t *count) {
    Doorway *doorways = memory_zeroed(check->plan->door_count, sizeof *doorways);
    *count = 0;
    for (size_t d = 0; d < check->plan->door_count; d++) {
        const Door *door = &check->plan->doors[d];
        if (is_sound(check, LIST_DOORS, d) && check_door(check, d))
            doorways[(*count)++] = (Doorway){door->wall_index, (size_t)door->segment, d, door->at - door->width / 2,
                                             door->at + door->width / 2};
    }
    qsort(doorways, *count, sizeof *doorways, compare_doorways);
    check_overlaps(check, doorways, *count);
    return doorways;
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

/* Solids in which people must not stand: furniture, then the segments of walls one by one, as items of a broad phase.
 */
typedef struct Solids {
    const Plan *plan;
    Broadphase *near;
    size_t *walls, *segments; /* of item furniture_count + i */
    const Doorway *doorways;  /* (doorway_count) in order */
    size_t doorway_count;
} Solids;

static Box box_of(const Vec2 *points, size_t count, double grown) {
    Box box = box_empty();
    for (size_t i = 0; i < count; i++)
        box = box_include(box, points[i]);
    return box_expand(box, grown);
}

static Solids solids_create(const Plan *plan, const Doorway *doorways, size_t doorway_count) {
    Solids solids = {.plan = plan, .near = broadphase_create(), .doorways = doorways, .doorway_count = doorway_count};
    size_t count = 0, used = 0;
    for (size_t w = 0; w < plan->wall_count; w++)
        count += plan->walls[w].points.count - 1;
    solids.walls = memory_zeroed(count, sizeof *solids.walls);
    solids.segments = memory_zeroed(count, sizeof *solids.segments);
    for (size_t f = 0; f < plan->furniture_count; f++) {
        Vec2 corners[4];
        plan_geometry_corners(&plan->furniture[f], corners);
        broadphase_insert(solids.near, box_of(corners, 4, 0), (int)f);
    }
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        for (size_t s = 0; s + 1 < wall->points.count; s++, used++) {
            solids.walls[used] = w;
            solids.segments[used] = s;
            broadphase_insert(solids.near, box_of(wall->points.at + s, 2, wall->thickness / 2),
                              (int)(plan->furniture_count + used));
        }
    }
    return solids;
}

static void solids_destroy(Solids *solids) {
    broadphase_destroy(solids->near);
    memory_free(solids->walls);
    memory_free(solids->segments);
}

static bool in_doorway(const Solids *solids, size_t wall, size_t segment, double along) {
    const Doorway wanted = {.wall = wall, .segment = segment, .from = -HUGE_VAL};
    size_t low = 0, high = solids->doorway_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (compare_doorways(&solids->doorways[middle], &wanted) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < solids->doorway_count && same_segment(&solids->doorways[low], &wanted); low++) {
        const Door *door = &solids->plan->doors[solids->doorways[low].door];
        if (door->state != DOOR_LOCKED && fabs(along - door->at) < door->width / 2)
            return true;
    }
    return false;
}

/* True inside standing furniture. A lying piece has fallen on the person, which is not an error of the plan. */
static bool in_furniture(const Furniture *piece, Vec2 p) {
    Vec2 corners[4];
    plan_geometry_corners(piece, corners);
    return !piece->toppled && inside_corners(p, corners, 4);
}

static bool in_wall(const Solids *solids, size_t w, size_t s, Vec2 p) {
    const Wall *wall = &solids->plan->walls[w];
    Vec2 a = wall->points.at[s], b = wall->points.at[s + 1];
    return vec2_distance(p, vec2_nearest_on_segment(p, a, b)) < wall->thickness / 2 &&
           !in_doorway(solids, w, s, vec2_dot(vec2_sub(p, a), vec2_unit(vec2_sub(b, a))));
}

typedef struct Standing {
    const Solids *solids;
    Vec2 at;
    int inside; /* the first item that contains the person, INT_MAX: none */
} Standing;

static bool visit_solid(void *context, int item) {
    Standing *standing = context;
    const Solids *solids = standing->solids;
    size_t furniture = solids->plan->furniture_count, i = (size_t)item - furniture;
    if (item < standing->inside &&
        ((size_t)item < furniture ? in_furniture(&solids->plan->furniture[item], standing->at)
                                  : in_wall(solids, solids->walls[i], solids->segments[i], standing->at)))
        standing->inside = item;
    return true;
}

static void check_person(const PlanCheck *check, const Solids *solids, size_t p) {
    const Person *person = &check->plan->people[p];
    Standing standing = {solids, person->at, INT_MAX};
    broadphase_visit(solids->near, box_around(person->at, 0), visit_solid, &standing);
    if (standing.inside == INT_MAX)
        return;
    size_t item = (size_t)standing.inside, furniture = check->plan->furniture_count;
    char solid[100];
    if (item >= furniture) {
        snprintf(solid, sizeof solid, "wall %.40s", check->plan->walls[solids->walls[item - furniture]].id);
    } else {
        const Furniture *piece = &check->plan->furniture[item];
        if (!*piece->name || strcmp(piece->name, piece->id) == 0)
            snprintf(solid, sizeof solid, "furniture %.40s", piece->id);
        else
            snprintf(solid, sizeof solid, "%.40s (%.40s)", piece->name, piece->id);
    }
    add_fault(check, LIST_PEOPLE, p, "at", "person %.40s stands inside %s, must stand in free space", person->id,
              solid);
}

static void check_people(const PlanCheck *check, const Doorway *doorways, size_t doorway_count) {
    Solids solids = solids_create(check->plan, doorways, doorway_count);
    for (size_t p = 0; p < check->plan->person_count; p++)
        if (is_sound(check, LIST_PEOPLE, p))
            check_person(check, &solids, p);
    solids_destroy(&solids);
}

/* Checks what was measured on a route. */
static void check_observed(const PlanCheck *check, size_t r) {
    char fault[200];
    if (!observed_times_check(&check->plan->routes[r].observed, fault, sizeof fault))
        add_fault(check, LIST_ROUTES, r, "observed", "route %.40s: %s", check->plan->routes[r].id, fault);
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
        size_t p = plan_tables_find(plan, &plan_tables_lists[LIST_PEOPLE], id),
               c = plan_tables_find(plan, &plan_tables_lists[LIST_CROWDS], id);
        size_t *taken = p != SIZE_MAX ? &plan->people[p].route : c != SIZE_MAX ? &plan->crowds[c].route : NULL;
        if (!taken)
            add_fault(check, LIST_ROUTES, r, "people", "route %.40s: there is no person or crowd \"%.40s\"", route->id,
                      id);
        else if (*taken != SIZE_MAX)
            add_fault(check, LIST_ROUTES, r, "people",
                      "route %.40s: person %.40s already takes route %.40s, must take one only", route->id, id,
                      plan->routes[*taken].id);
        else
            *taken = r;
    }
    check_observed(check, r);
}

static void check_each(const PlanCheck *check, int list, void (*check_element)(const PlanCheck *check, size_t index)) {
    for (size_t i = 0; i < plan_tables_count(check->plan, &plan_tables_lists[list]); i++)
        if (is_sound(check, list, i))
            check_element(check, i);
}

static void check_sampling(const PlanCheck *check) {
    const RunSettings *run = &check->plan->run;
    JsonNode node = json_member(check->root, "run");
    JsonNode sample = json_member(&node, "sample");
    const JsonNode *place = sample.value ? &sample : node.value ? &node : check->root;
    if (run->sample < run->dt)
        json_fault(place, check->fault, "sample is %g s, must be at least the step dt, %g s", run->sample, run->dt);
}

static void check_crowds(const PlanCheck *check) {
    JsonNode node = json_member(check->root, "crowds");
    double people = (double)check->plan->person_count;
    for (size_t c = 0; c < check->plan->crowd_count; c++)
        people += check->plan->crowds[c].count;
    if (people > MOST_PEOPLE)
        json_fault(node.value ? &node : check->root, check->fault, "%.0f people in all, must be at most %.0f", people,
                   MOST_PEOPLE);
}

void plan_check_whole(const PlanCheck *check) {
    check_unique_ids(check);
    size_t before = check->fault->total;
    check_each(check, LIST_WALLS, check_wall);
    size_t doorway_count;
    Doorway *doorways = check_doors(check, &doorway_count);
    check_each(check, LIST_FURNITURE, check_piece);
    bool solid = check->fault->total == before && all_sound(check, LIST_WALLS) && all_sound(check, LIST_DOORS) &&
                 all_sound(check, LIST_FURNITURE);
    check_each(check, LIST_EXITS, check_exit);
    if (solid)
        check_people(check, doorways, doorway_count);
    memory_free(doorways);
    for (size_t p = 0; p < check->plan->person_count; p++)
        check->plan->people[p].route = SIZE_MAX;
    for (size_t c = 0; c < check->plan->crowd_count; c++)
        check->plan->crowds[c].route = SIZE_MAX;
    check_each(check, LIST_ROUTES, check_route);
    check_sampling(check);
    check_crowds(check);
}
