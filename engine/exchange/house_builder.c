#include "exchange/house_builder.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "exchange/bounding_rectangle.h"
#include "plan/plan_tables.h"

static const double ROUNDED = 1e9;  /* per m: coordinates are rounded to a nanometre, for readable files */
static const double FARTHEST = 1e8; /* m, before the plan is moved to its origin: larger coordinates are not on Earth */
static const double APART = 1e-6;   /* m: shortest wall segment of a plan */
static const double SMALLEST = 0.01;   /* m: smallest side of furniture and exits in a plan */
static const double PARALLEL = 0.1;    /* 1: sine of the largest angle between a door and its wall */
static const double THICKEST = 5;      /* m, limits of the parameter tables */
static const double HIGHEST = 100;     /* m */
static const double WIDEST_DOOR = 100; /* m */

enum { TEXT_LONGEST = 80 /* bytes in a name */ };

/* Returns arbitrary text from a file as one short line. */
static const char *kept_text(HouseBuilder *builder, const char *text) {
    char line[TEXT_LONGEST + 1];
    snprintf(line, sizeof line, "%.*s", text_fitting(text, TEXT_LONGEST), text);
    text_make_plain(line);
    return arena_text(&builder->plan.arena, line);
}

void house_builder_init(HouseBuilder *builder, const char *path, const ImportOptions *options, ImportReport *report,
                        Fault *fault) {
    *builder = (HouseBuilder){.path = path, .line = 1, .options = options, .report = report, .fault = fault};
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *ending = strrchr(name, '.');
    const char *bare = text_in_arena(&builder->plan.arena, "%.*s", ending ? (int)(ending - name) : -1, name);
    builder->plan.name = kept_text(builder, bare);
    parameters_reset(&plan_tables_run, &builder->plan.run);
}

void house_builder_clear(HouseBuilder *builder) {
    for (size_t l = 0; l < PLAN_LISTS; l++)
        memory_free(*(void **)((char *)&builder->plan + plan_tables_lists[l].array));
    plan_free(&builder->plan);
}

bool house_builder_fail(HouseBuilder *builder, const char *format, ...) {
    if (builder->failed)
        return false;
    builder->failed = true;
    va_list arguments;
    va_start(arguments, format);
    char *what = text_printed(format, arguments);
    va_end(arguments);
    fault_add(builder->fault, "%s:%d:1: %s", builder->path, builder->line, what);
    memory_free(what);
    return false;
}

void house_builder_name(HouseBuilder *builder, const char *name) {
    if (*name)
        builder->plan.name = kept_text(builder, name);
}

bool house_builder_good(HouseBuilder *builder, Vec2 at) {
    if (fabs(at.x) < FARTHEST && fabs(at.y) < FARTHEST)
        return !builder->failed;
    return house_builder_fail(builder, "the point (%g, %g) m is too far away, must be within %g m", at.x, at.y,
                              FARTHEST);
}

Vec2 house_builder_rounded(Vec2 at) {
    return vec2(round(at.x * ROUNDED) / ROUNDED, round(at.y * ROUNDED) / ROUNDED);
}

static double rounded_length(double length) {
    return round(length * ROUNDED) / ROUNDED;
}

/* Returns rounded copies of valid points, in the arena, or NULL if a point is invalid. */
static Vec2 *keep_points(HouseBuilder *builder, const Vec2 *points, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (!house_builder_good(builder, points[i]))
            return NULL;
    Vec2 *kept = arena_allocate(&builder->plan.arena, count * sizeof *kept);
    for (size_t i = 0; i < count; i++)
        kept[i] = house_builder_rounded(points[i]);
    return kept;
}

/* Appends an element with default values to a list of the plan and gives it an id: the list's first letter and a
 * number. NULL: the list already has `most` elements. */
static void *add_element(HouseBuilder *builder, int list, size_t *capacity, size_t most) {
    const PlanList *kind = &plan_tables_lists[list];
    void **array = (void **)((char *)&builder->plan + kind->array);
    size_t *count = (size_t *)((char *)&builder->plan + kind->count);
    if (builder->failed)
        return NULL;
    if (*count >= most) {
        house_builder_fail(builder, "more than %zu %s, must be fewer", most, kind->key);
        return NULL;
    }
    *array = memory_reserve(*array, capacity, *count + 1, kind->size);
    void *element = (char *)*array + (*count)++ * kind->size;
    parameters_reset(&kind->table, element);
    const char *letters = list == LIST_ROUTES ? "route" : list == LIST_ROOMS ? "room" : NULL;
    char letter[2] = {kind->key[0], 0};
    *(const char **)element = text_in_arena(&builder->plan.arena, "%s%zu", letters ? letters : letter, *count);
    return element;
}

/* Walls and doors ------------------------------------------------------------------------------------------------- */

size_t house_builder_wall(HouseBuilder *builder, const Vec2 *points, size_t count, double thickness, double height) {
    Vec2 *kept = keep_points(builder, points, count);
    size_t used = 0;
    for (size_t i = 0; i < count && kept; i++)
        if (used == 0 || vec2_distance(kept[i], kept[used - 1]) >= APART)
            kept[used++] = kept[i];
    if (used < 2)
        return SIZE_MAX;
    if (builder->points + used > HOUSE_BUILDER_POINTS) {
        house_builder_fail(builder, "walls of more than %d points, must be fewer", HOUSE_BUILDER_POINTS);
        return SIZE_MAX;
    }
    Wall *wall = add_element(builder, LIST_WALLS, &builder->wall_capacity, HOUSE_BUILDER_POINTS);
    if (!wall)
        return SIZE_MAX;
    builder->points += used;
    wall->points = (Points){kept, used};
    wall->thickness = thickness >= 0 ? rounded_length(fmin(thickness, THICKEST)) : 0;
    if (height > 0)
        wall->height = rounded_length(fmin(height, HIGHEST));
    return builder->plan.wall_count - 1;
}

static bool overlaps(const HouseBuilder *builder, const Door *door) {
    for (size_t d = 0; d < builder->plan.door_count; d++) {
        const Door *other = &builder->plan.doors[d];
        if (other->wall_index == door->wall_index && other->segment == door->segment &&
            fabs(other->at - door->at) < (other->width + door->width) / 2 + APART)
            return true;
    }
    return false;
}

size_t house_builder_door(HouseBuilder *builder, const Door *door) {
    const Wall *wall = &builder->plan.walls[door->wall_index];
    const Vec2 *ends = wall->points.at + door->segment;
    Door placed = *door;
    double length = vec2_distance(ends[0], ends[1]);
    placed.width = rounded_length(fmin(door->width, length));
    double half = placed.width / 2;
    bool fits = door->width >= SMALLEST && door->width <= fmin(length + APART, WIDEST_DOOR) && door->at >= -half &&
                door->at <= length + half;
    placed.at = fits ? rounded_length(real_clamp(door->at, half, fmax(length - half, half))) : 0;
    if (!fits || overlaps(builder, &placed))
        return SIZE_MAX;
    Door *added = add_element(builder, LIST_DOORS, &builder->door_capacity, HOUSE_BUILDER_FEW);
    if (!added)
        return SIZE_MAX;
    placed.id = added->id;
    placed.wall = wall->id;
    placed.state = added->state;
    placed.opening_time = added->opening_time;
    placed.leaf = added->leaf;
    *added = placed;
    return builder->plan.door_count - 1;
}

bool house_builder_nearest(const HouseBuilder *builder, Vec2 at, Vec2 along, double reach, size_t *wall, int *segment) {
    double best = reach;
    bool found = false;
    for (size_t w = 0; w < builder->plan.wall_count; w++) {
        const Points *points = &builder->plan.walls[w].points;
        for (size_t s = 0; s + 1 < points->count; s++) {
            Vec2 a = points->at[s], b = points->at[s + 1];
            double distance = vec2_distance(at, vec2_nearest_on_segment(at, a, b));
            if (distance > best || fabs(vec2_cross(vec2_unit(vec2_sub(b, a)), along)) > PARALLEL)
                continue;
            best = distance;
            *wall = w;
            *segment = (int)s;
            found = true;
        }
    }
    return found;
}

/* Furniture, rooms, exits ----------------------------------------------------------------------------------------- */

size_t house_builder_piece(HouseBuilder *builder, const char *name, Vec2 centre, Vec2 size, double angle,
                           double height) {
    if (!house_builder_good(builder, centre) || !house_builder_good(builder, size) || size.x < SMALLEST ||
        size.y < SMALLEST)
        return SIZE_MAX;
    Furniture *piece = add_element(builder, LIST_FURNITURE, &builder->furniture_capacity, HOUSE_BUILDER_THINGS);
    if (!piece)
        return SIZE_MAX;
    piece->name = kept_text(builder, name);
    piece->centre = house_builder_rounded(centre);
    piece->size = house_builder_rounded(size);
    piece->angle = isfinite(angle) ? rounded_length(remainder(angle, 360)) : 0;
    if (height > 0)
        piece->height = rounded_length(fmin(height, HIGHEST));
    return builder->plan.furniture_count - 1;
}

size_t house_builder_piece_around(HouseBuilder *builder, const char *name, const Vec2 *points, size_t count,
                                  double height) {
    for (size_t i = 0; i < count; i++)
        if (!house_builder_good(builder, points[i]))
            return SIZE_MAX;
    if (count < 2)
        return SIZE_MAX;
    Rectangle box = bounding_rectangle_of(points, count);
    return house_builder_piece(builder, name, box.centre, box.size, box.angle, height);
}

size_t house_builder_room(HouseBuilder *builder, const char *name, const Vec2 *points, size_t count) {
    Vec2 *kept = count >= 3 ? keep_points(builder, points, count) : NULL;
    Room *room = kept ? add_element(builder, LIST_ROOMS, &builder->room_capacity, HOUSE_BUILDER_THINGS) : NULL;
    if (!room)
        return SIZE_MAX;
    room->name = kept_text(builder, name);
    room->outline = (Points){kept, count};
    return builder->plan.room_count - 1;
}

size_t house_builder_exit(HouseBuilder *builder, Vec2 from, Vec2 to) {
    if (!house_builder_good(builder, from) || !house_builder_good(builder, to) ||
        vec2_distance(from, to) < 1.01 * SMALLEST)
        return SIZE_MAX;
    Exit *exit = add_element(builder, LIST_EXITS, &builder->exit_capacity, HOUSE_BUILDER_THINGS);
    if (!exit)
        return SIZE_MAX;
    exit->from = house_builder_rounded(from);
    exit->to = house_builder_rounded(to);
    return builder->plan.exit_count - 1;
}

/* People ---------------------------------------------------------------------------------------------------------- */

static const char walker[] = "adult"; /* the shipped profile nearest to other programs' pedestrians */

size_t house_builder_person(HouseBuilder *builder, Vec2 at, double heading, double speed) {
    Person *person = house_builder_good(builder, at)
                         ? add_element(builder, LIST_PEOPLE, &builder->person_capacity, HOUSE_BUILDER_FEW)
                         : NULL;
    if (!person)
        return SIZE_MAX;
    person->profile = walker;
    person->at = house_builder_rounded(at);
    person->heading = isfinite(heading) ? rounded_length(remainder(heading, 360)) : 0;
    person->speed = speed > 0 ? rounded_length(fmin(speed, 10)) : 0;
    return builder->plan.person_count - 1;
}

size_t house_builder_crowd(HouseBuilder *builder, const Vec2 *area, size_t points, size_t count, double delay) {
    if (count < 1 || points < 3)
        return SIZE_MAX;
    if (builder->crowd + count > HOUSE_BUILDER_CROWD) {
        house_builder_fail(builder, "more than %d people, must be fewer", HOUSE_BUILDER_CROWD);
        return SIZE_MAX;
    }
    Vec2 *kept = keep_points(builder, area, points);
    Crowd *crowd = kept ? add_element(builder, LIST_CROWDS, &builder->crowd_capacity, HOUSE_BUILDER_FEW) : NULL;
    if (!crowd)
        return SIZE_MAX;
    builder->crowd += count;
    crowd->profile = walker;
    crowd->count = (int)count;
    crowd->area = (Points){kept, points};
    crowd->delay = delay > 0 ? rounded_length(fmin(delay, 1e6)) : 0;
    return builder->plan.crowd_count - 1;
}

/* Returns the route with the same exit and intermediate points, or NULL. */
static PlanRoute *find_route(const Plan *plan, const Vec2 *via, size_t count, const char *exit) {
    for (size_t r = 0; r < plan->route_count; r++) {
        PlanRoute *route = &plan->routes[r];
        if (route->via.count == count && (!count || memcmp(route->via.at, via, count * sizeof *via) == 0) &&
            strcmp(route->exit, exit) == 0)
            return route;
    }
    return NULL;
}

/* The capacity doubles whenever the count reaches a power of two. */
static void add_to_route(HouseBuilder *builder, PlanRoute *route, const char *who) {
    Ids *people = &route->people;
    if ((people->count & (people->count - 1)) == 0) {
        const char **more = arena_allocate(&builder->plan.arena, (2 * people->count + 1) * sizeof *more);
        for (size_t i = 0; i < people->count; i++)
            more[i] = people->at[i];
        people->at = more;
    }
    people->at[people->count++] = who;
}

void house_builder_route(HouseBuilder *builder, const char *who, const Vec2 *via, size_t count, size_t exit) {
    const char *id = exit < builder->plan.exit_count ? builder->plan.exits[exit].id : "";
    Vec2 *kept = keep_points(builder, via, count);
    PlanRoute *route = kept ? find_route(&builder->plan, kept, count, id) : NULL;
    if (kept && !route) {
        route = add_element(builder, LIST_ROUTES, &builder->route_capacity, HOUSE_BUILDER_FEW);
        if (route) {
            route->via = (Points){kept, count};
            route->exit = id;
        }
    }
    if (route)
        add_to_route(builder, route, who);
}
