#include "laboratory/house_items.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "laboratory/wall_outline.h"
#include "plan/plan_geometry.h"
#include "result/census.h"
#include "result/jam.h"
#include "result/names.h"
#include "result/tight.h"
#include "visual/house/blockage_scene.h"
#include "visual/house/people_scene.h"
#include "visual/house/silhouette.h"

#define LEAST_DEPTH 0.10  /* m, least depth of the outline of a thin item, so that it can be clicked */
#define EXIT_DEPTH 0.20   /* m */
#define HAZARD_SHOWN 0.25 /* m, radius of a dangerous point's outline */
#define STOP_SHOWN 0.50   /* m, radius of a stopped person's outline */

enum { CIRCLE = 24 /* points of a circle */ };

static const HouseItem order[] = {HOUSE_PERSON, HOUSE_HAZARD, HOUSE_DOOR, HOUSE_FURNITURE, HOUSE_WALL, HOUSE_EXIT};
enum { KINDS = sizeof order / sizeof *order };

/* Returns the number of items of a kind in a plan; 0: of another kind. */
static size_t count_in(const Plan *plan, int kind) {
    return kind == HOUSE_DOOR        ? plan->door_count
           : kind == HOUSE_FURNITURE ? plan->furniture_count
           : kind == HOUSE_WALL      ? plan->wall_count
           : kind == HOUSE_EXIT      ? plan->exit_count
                                     : 0;
}

size_t house_item_count(const House *house, const Observation *observation, int kind) {
    switch ((HouseItem)kind) {
    case HOUSE_PERSON:
        return house->person_count;
    case HOUSE_HAZARD:
        return observation ? tight_places(house, observation, (Tight[TIGHT_MOST]){{0}}) : 0;
    case HOUSE_DOOR:
    case HOUSE_FURNITURE:
    case HOUSE_WALL:
    case HOUSE_EXIT:
        return count_in(&house->plan, kind);
    case HOUSE_STOP:
        return observation ? observation->person_count : 0;
    case HOUSE_NOTHING:
    case HOUSE_ITEMS:
        break;
    }
    return 0;
}

/* Returns the id of an item of a plan, or "". */
static const char *id_in(const Plan *plan, Item item) {
    size_t i = item.index;
    return item.kind == HOUSE_DOOR        ? plan->doors[i].id
           : item.kind == HOUSE_FURNITURE ? plan->furniture[i].id
           : item.kind == HOUSE_WALL      ? plan->walls[i].id
           : item.kind == HOUSE_EXIT      ? plan->exits[i].id
                                          : "";
}

const char *house_item_id(const House *house, Item item) {
    return item.kind == HOUSE_PERSON ? house->people[item.index].id : id_in(&house->plan, item);
}

Item house_item_in(const Plan *plan, int kind, const char *id) {
    for (size_t i = 0; i < count_in(plan, kind); i++)
        if (strcmp(id_in(plan, (Item){kind, i}), id) == 0)
            return (Item){kind, i};
    return (Item){0, 0};
}

Item house_item_find(const House *house, int kind, const char *id) {
    for (size_t i = 0; i < house_item_count(house, NULL, kind); i++)
        if (strcmp(house_item_id(house, (Item){kind, i}), id) == 0)
            return (Item){kind, i};
    return (Item){0, 0};
}

const Hazard *house_item_hazard(const House *house, const Observation *observation, size_t place) {
    Tight tight[TIGHT_MOST];
    size_t count = tight_places(house, observation, tight);
    return place < count ? &observation->hazards[tight[place].hazard] : NULL;
}

void house_item_key(const House *house, const Observation *observation, Item item, char *key, size_t size) {
    *key = 0;
    if (item.index >= house_item_count(house, observation, item.kind))
        return;
    const char *id = house_item_id(house, item);
    if (item.kind == HOUSE_HAZARD)
        snprintf(key, size, "tight place %zu: %s", item.index + 1,
                 house_item_hazard(house, observation, item.index)->what);
    else if (item.kind == HOUSE_STOP)
        snprintf(key, size, "%s stops at %s", house->people[item.index].id,
                 observation->people[item.index].blockage.what);
    else if (item.kind == HOUSE_FURNITURE)
        outline_name(&house->plan, OWNER_FURNITURE, (int)item.index, key, size);
    else
        snprintf(key, size, "%s %s",
                 item.kind == HOUSE_PERSON ? "person"
                 : item.kind == HOUSE_DOOR ? "door"
                 : item.kind == HOUSE_WALL ? "wall"
                                           : "exit",
                 id);
}

static void name_furniture(const Furniture *piece, char *name, size_t size) {
    snprintf(name, size, "%s", *piece->name ? piece->name : "furniture");
}

/* "A is caught under cupboard", "A starts inside wall", "A stops at porch door". */
static void name_stop(const House *house, const Observation *observation, size_t person, char *name, size_t size) {
    Arena arena = {0};
    const Blockage *blockage = &observation->people[person].blockage;
    const char *who = names_person(house, person, &arena), *start = census_start(blockage);
    if (house->people[person].under)
        snprintf(name, size, "%s is caught %s", who, names_text(house, blockage->what, &arena));
    else if (start)
        snprintf(name, size, "%s starts %s", who, names_text(house, start, &arena));
    else
        snprintf(name, size, "%s stops at %s", who, names_text(house, blockage->what, &arena));
    arena_clear(&arena);
}

void house_item_name(const House *house, const Observation *observation, Item item, char *name, size_t size) {
    *name = 0;
    if (item.index >= house_item_count(house, observation, item.kind))
        return;
    Arena arena = {0};
    if (item.kind == HOUSE_HAZARD)
        snprintf(name, size, "%s %zu: %s", house->person_count > PEOPLE_SCENE_INDIVIDUALS ? "jam" : "tight place",
                 item.index + 1, jam_name(house, house_item_hazard(house, observation, item.index), &arena));
    else if (item.kind == HOUSE_STOP)
        name_stop(house, observation, item.index, name, size);
    else if (item.kind == HOUSE_FURNITURE)
        name_furniture(&house->plan.furniture[item.index], name, size);
    else if (item.kind == HOUSE_DOOR)
        snprintf(name, size, "%s", names_door(&house->plan, item.index, &arena));
    else if (item.kind == HOUSE_PERSON)
        snprintf(name, size, "%s, %s", names_person(house, item.index, &arena),
                 names_profile(house->people[item.index].profile->name));
    else if (item.kind == HOUSE_WALL)
        snprintf(name, size, "%s", names_wall(&house->plan, item.index, &arena));
    else
        snprintf(name, size, "exit %s", house_item_id(house, item));
    arena_clear(&arena);
}

void house_item_name_at(const House *house, const Observation *observation, Item item, Vec2 at, char *name,
                        size_t size) {
    Arena arena = {0};
    if (item.kind == HOUSE_WALL && item.index < house->plan.wall_count)
        snprintf(name, size, "%s", names_wall_at(&house->plan, item.index, at, &arena));
    else
        house_item_name(house, observation, item, name, size);
    arena_clear(&arena);
}

/* Outlines -------------------------------------------------------------------------------------------------------- */

/* Writes the outline of a strip along a segment, counter-clockwise. */
static size_t outline_strip(Vec2 from, Vec2 to, double depth, Vec2 *points) {
    Vec2 side = vec2_scale(vec2_left(vec2_unit(vec2_sub(to, from))), fmax(depth, LEAST_DEPTH) / 2);
    points[0] = vec2_sub(from, side);
    points[1] = vec2_sub(to, side);
    points[2] = vec2_add(to, side);
    points[3] = vec2_add(from, side);
    return 4;
}

static size_t outline_person(const HouseScenery *scenery, size_t i, double time, Vec2 *points) {
    const PersonObservation *observed = &scenery->observation->people[i];
    const Trail *trail = &scenery->trails[i];
    bool crowd = scenery->house->person_count > PEOPLE_SCENE_INDIVIDUALS;
    if (!observed->took_part || !trail->count || !people_scene_is_drawn(scenery->observation, i, time, crowd))
        return 0;
    Pose pose = trail_pose(trail, time);
    silhouette_outline(scenery->house->people[i].profile, pose.at, pose.heading, 0, points);
    return SILHOUETTE_POINTS;
}

static size_t outline_circle(Vec2 middle, double radius, Vec2 *points) {
    for (int i = 0; i < CIRCLE; i++)
        points[i] = vec2_along(middle, radius, vec2_heading(2 * M_PI * i / CIRCLE));
    return CIRCLE;
}

size_t house_item_outline_in(const Plan *plan, Item item, Vec2 *points) {
    Vec2 from, to;
    switch (item.kind) {
    case HOUSE_DOOR:
        plan_geometry_door_ends(plan, &plan->doors[item.index], &from, &to);
        return outline_strip(from, to, plan->walls[plan->doors[item.index].wall_index].thickness, points);
    case HOUSE_FURNITURE:
        plan_geometry_corners(&plan->furniture[item.index], points);
        return 4;
    case HOUSE_WALL:
        return wall_outline_write(plan, item.index, LEAST_DEPTH, points, LABORATORY_OUTLINE_MOST);
    case HOUSE_EXIT:
        return outline_strip(plan->exits[item.index].from, plan->exits[item.index].to, EXIT_DEPTH, points);
    default:
        return 0;
    }
}

size_t house_item_outline(const HouseScenery *scenery, Item item, double time, Vec2 *points) {
    if (item.index >= house_item_count(scenery->house, scenery->observation, item.kind))
        return 0;
    switch ((HouseItem)item.kind) {
    case HOUSE_PERSON:
        return outline_person(scenery, item.index, time, points);
    case HOUSE_HAZARD:
        return outline_circle(house_item_hazard(scenery->house, scenery->observation, item.index)->at, HAZARD_SHOWN,
                              points);
    case HOUSE_STOP:
        if (!blockage_scene_has(&scenery->observation->people[item.index]))
            return 0;
        return outline_circle(scenery->observation->people[item.index].blockage.at, STOP_SHOWN, points);
    case HOUSE_DOOR:
    case HOUSE_FURNITURE:
    case HOUSE_WALL:
    case HOUSE_EXIT:
        return house_item_outline_in(&scenery->house->plan, item, points);
    case HOUSE_NOTHING:
    case HOUSE_ITEMS:
        break;
    }
    return 0;
}

/* Picking --------------------------------------------------------------------------------------------------------- */

typedef struct Hit {
    Item item;
    double area; /* m2 */
} Hit;

static bool holds(const Vec2 *points, size_t count, Vec2 p) {
    bool inside = false;
    for (size_t i = 0, j = count - 1; i < count; j = i++)
        if ((points[i].y > p.y) != (points[j].y > p.y) &&
            p.x < points[i].x + (p.y - points[i].y) / (points[j].y - points[i].y) * (points[j].x - points[i].x))
            inside = !inside;
    return inside;
}

static double area_of(const Vec2 *points, size_t count) {
    double twice = 0;
    for (size_t i = 0, j = count - 1; i < count; j = i++)
        twice += vec2_cross(points[j], points[i]);
    return fabs(twice) / 2;
}

/* True if a point lies within half the wall's thickness of its centre line, also where it has a door; the area of
 * walls is that of all their sides. */
static bool hits_wall(const Wall *wall, Vec2 p, double *area) {
    double depth = fmax(wall->thickness, LEAST_DEPTH);
    bool hit = false;
    *area = 0;
    for (size_t i = 1; i < wall->points.count; i++) {
        Vec2 a = wall->points.at[i - 1], b = wall->points.at[i];
        *area += depth * vec2_distance(a, b);
        hit |= vec2_distance(p, vec2_nearest_on_segment(p, a, b)) <= depth / 2;
    }
    return hit;
}

/* True if a person is so far from the point that the outline need not be made. */
static bool is_far(const HouseScenery *scenery, size_t person, Vec2 at, double time) {
    const Profile *profile = scenery->house->people[person].profile;
    const Trail *trail = &scenery->trails[person];
    return !trail->count || vec2_distance(trail_pose(trail, time).at, at) > profile->length + profile->width;
}

static bool hits(const HouseScenery *scenery, Hit *hit, Vec2 at, double time) {
    Vec2 points[LABORATORY_OUTLINE_MOST];
    if (hit->item.kind == HOUSE_PERSON && is_far(scenery, hit->item.index, at, time))
        return false;
    if (hit->item.kind == HOUSE_WALL)
        return hits_wall(&scenery->house->plan.walls[hit->item.index], at, &hit->area);
    size_t count = house_item_outline(scenery, hit->item, time, points);
    hit->area = area_of(points, count);
    return count && holds(points, count, at);
}

static int rank_of(int kind) {
    int rank = 0;
    while (rank < KINDS && (int)order[rank] != kind)
        rank++;
    return rank;
}

/* Sorts smaller items first; walls, which lie behind all other items, last. */
static int compare_hits(const void *a, const void *b) {
    const Hit *p = a, *q = b;
    if ((p->item.kind == HOUSE_WALL) != (q->item.kind == HOUSE_WALL))
        return p->item.kind == HOUSE_WALL ? 1 : -1;
    if (p->area != q->area)
        return (p->area > q->area) - (p->area < q->area);
    int ranks = rank_of(p->item.kind) - rank_of(q->item.kind);
    return ranks ? ranks : (p->item.index > q->item.index) - (p->item.index < q->item.index);
}

Item house_item_at(const HouseScenery *scenery, Vec2 at, double time, Item below) {
    Hit *list = NULL;
    size_t count = 0, capacity = 0, chosen = 0;
    for (size_t k = 0; k < KINDS; k++)
        for (size_t i = 0; i < house_item_count(scenery->house, scenery->observation, (int)order[k]); i++) {
            Hit hit = {.item = {(int)order[k], i}};
            if (!hits(scenery, &hit, at, time))
                continue;
            list = memory_reserve(list, &capacity, count + 1, sizeof *list);
            list[count++] = hit;
        }
    if (count > 1)
        qsort(list, count, sizeof *list, compare_hits);
    for (size_t i = 0; i < count; i++)
        if (below.kind && item_same(list[i].item, below))
            chosen = (i + 1) % count;
    Item item = count ? list[chosen].item : (Item){0, 0};
    memory_free(list);
    return item;
}

Item house_item_next(const HouseScenery *scenery, Item item, int step) {
    size_t total = 0, place = 0;
    for (size_t k = 0; k < KINDS; k++) {
        if ((int)order[k] == item.kind)
            place = total + item.index;
        total += house_item_count(scenery->house, scenery->observation, (int)order[k]);
    }
    if (!total)
        return (Item){0, 0};
    if (item.kind == HOUSE_NOTHING)
        place = step > 0 ? total - 1 : 0;
    place = (place + total + (size_t)(step > 0 ? 1 : total - 1)) % total;
    for (size_t k = 0; k < KINDS; k++) {
        size_t count = house_item_count(scenery->house, scenery->observation, (int)order[k]);
        if (place < count)
            return (Item){(int)order[k], place};
        place -= count;
    }
    return (Item){0, 0};
}
