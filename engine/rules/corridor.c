#include "rules/corridor.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "plan/plan_geometry.h"
#include "rules/surroundings.h"

static const double BESIDE = 0.05; /* m, left out beside an opening */
static const double ASKEW = 0.7;   /* 1, cosine of the angle between way and line from which on a place is left out */
static const double BRIDGED = 0.5; /* m of a way that may be wider, at a corner, without ending a corridor */
static const double EQUAL = 1e-5;  /* m: numerics, of widths that count as equal */
static const double CELL = 0.3;    /* m, of the grid on which ways count as the same */
static const double LARGEST = 4e6; /* cells of that grid */

/* What is measured at a place of a way. */
typedef enum PlaceKind { PLACE_LEFT_OUT, PLACE_OPENING, PLACE_WIDE, PLACE_MEASURED } PlaceKind;

typedef struct Measuring {
    const House *house;
    Surroundings walls, near; /* the walls alone, and everything */
    Corridors *corridors;
    size_t *doors_of_room; /* (room_count) */
    bool *exits_of_room;   /* (room_count) */
    CorridorWidth *run;    /* (run_count) of the stretch so far */
    size_t run_count, run_capacity;
    double furnished;  /* m, of the stretch so far */
    double wide_since; /* m; negative: not wide now */
} Measuring;

/* Which rooms have how many doors ---------------------------------------------------------------------------------- */

static void count_openings(Measuring *measuring) {
    const Plan *plan = &measuring->house->plan;
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        Vec2 middle = vec2_scale(vec2_add(from, to), 0.5), out = vec2_left(vec2_unit(vec2_sub(to, from)));
        double off = plan->walls[plan->doors[d].wall_index].thickness / 2 + 2 * BESIDE;
        for (int side = -1; side <= 1; side += 2) {
            size_t room = ways_room(plan, vec2_along(middle, side * off, out));
            if (room != SIZE_MAX)
                measuring->doors_of_room[room]++;
        }
    }
    for (size_t e = 0; e < plan->exit_count; e++) {
        Vec2 middle = vec2_scale(vec2_add(plan->exits[e].from, plan->exits[e].to), 0.5);
        Vec2 out = vec2_left(vec2_unit(vec2_sub(plan->exits[e].to, plan->exits[e].from)));
        for (int side = -1; side <= 1; side += 2) {
            size_t room = ways_room(plan, vec2_along(middle, side * 2 * BESIDE, out));
            if (room != SIZE_MAX)
                measuring->exits_of_room[room] = true;
        }
    }
}

/* True in a room with a single door in which the way begins. */
static bool is_dead_end(const Measuring *measuring, const RuleWay *way, Vec2 at) {
    size_t room = way->room;
    return room != SIZE_MAX && measuring->doors_of_room[room] == 1 && !measuring->exits_of_room[room] &&
           ways_room(&measuring->house->plan, at) == room;
}

/* The width at a place ----------------------------------------------------------------------------------------------
 */

/* True if the line from a to b, widened to both sides, meets the opening of a door. */
static bool meets_opening(const Plan *plan, Vec2 a, Vec2 b) {
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        Vec2 along = vec2_unit(vec2_sub(to, from));
        if (ways_meet(a, b, vec2_along(from, -BESIDE, along), vec2_along(to, BESIDE, along)))
            return true;
    }
    return false;
}

static PlaceKind measure_place(Measuring *measuring, Vec2 at, Vec2 along, CorridorWidth *width) {
    const Plan *plan = &measuring->house->plan;
    Vec2 wall = at;
    if (ways_in_opening(plan, at, BESIDE))
        return PLACE_OPENING;
    if (!surroundings_nearest(&measuring->walls, at, CORRIDOR_WIDEST, SEE_WALLS, &wall))
        return PLACE_LEFT_OUT;
    Vec2 across = vec2_unit(vec2_sub(at, wall));
    if (fabs(vec2_dot(across, along)) > ASKEW)
        return PLACE_LEFT_OUT;
    double rest = surroundings_ray(&measuring->walls, at, across, CORRIDOR_WIDEST, SEE_WALLS);
    width->at = at;
    width->from = wall;
    width->width = vec2_distance(wall, at) + rest;
    width->to = vec2_along(at, rest, across);
    if (meets_opening(plan, width->from, width->to))
        return PLACE_LEFT_OUT;
    if (width->width >= CORRIDOR_WIDEST)
        return PLACE_WIDE;
    double left = surroundings_ray(&measuring->near, at, across, rest, SEE_ALL);
    double near = vec2_distance(wall, at);
    double right = surroundings_ray(&measuring->near, at, vec2_scale(across, -1), near, SEE_ALL);
    measuring->furnished = fmin(measuring->furnished, left + right);
    width->rails[0] = near - surroundings_ray(&measuring->near, at, vec2_scale(across, -1), near, SEE_RAILS);
    width->rails[1] = rest - surroundings_ray(&measuring->near, at, across, rest, SEE_RAILS);
    return PLACE_MEASURED;
}

/* Stretches ---------------------------------------------------------------------------------------------------------
 */

static int *cell_at(const Corridors *corridors, Vec2 at, int di, int dj) {
    int i = (int)((at.x - corridors->origin.x) / corridors->cell) + di;
    int j = (int)((at.y - corridors->origin.y) / corridors->cell) + dj;
    bool inside = i >= 0 && j >= 0 && i < corridors->nx && j < corridors->ny;
    return inside ? &corridors->covered[(size_t)j * (size_t)corridors->nx + (size_t)i] : NULL;
}

size_t corridor_at(const Corridors *corridors, Vec2 at) {
    int *own = cell_at(corridors, at, 0, 0);
    if (own && *own)
        return (size_t)*own - 1;
    for (int dj = -1; dj <= 1; dj++)
        for (int di = -1; di <= 1; di++) {
            const int *cell = cell_at(corridors, at, di, dj);
            if (cell && *cell)
                return (size_t)*cell - 1;
        }
    return SIZE_MAX;
}

static void add_width(Corridor *corridor, const CorridorWidth *width) {
    corridor->widths =
        memory_reserve(corridor->widths, &corridor->capacity, corridor->count + 1, sizeof *corridor->widths);
    corridor->widths[corridor->count++] = *width;
}

/* Ends the stretch: what no corridor covers yet belongs to the one that covers a part of it, or is a new one. */
static void end_run(Measuring *measuring) {
    Corridors *corridors = measuring->corridors;
    size_t count = measuring->run_count, into = SIZE_MAX;
    measuring->run_count = 0;
    measuring->wide_since = -1;
    double furnished = measuring->furnished;
    measuring->furnished = HUGE_VAL;
    if (count < 2 || measuring->run[count - 1].s - measuring->run[0].s <= CORRIDOR_SHORTEST)
        return;
    size_t *covers = memory_zeroed(count, sizeof *covers);
    for (size_t i = 0; i < count; i++) {
        covers[i] = corridor_at(corridors, measuring->run[i].at);
        into = into == SIZE_MAX ? covers[i] : into;
    }
    if (into == SIZE_MAX) {
        corridors->list =
            memory_reserve(corridors->list, &corridors->capacity, corridors->count + 1, sizeof *corridors->list);
        into = corridors->count++;
        corridors->list[into].furnished = HUGE_VAL;
    }
    Corridor *corridor = &corridors->list[into];
    corridor->furnished = fmin(corridor->furnished, furnished);
    for (size_t i = 0; i < count; i++) {
        if (covers[i] != SIZE_MAX)
            continue;
        add_width(corridor, &measuring->run[i]);
        int *cell = cell_at(corridors, measuring->run[i].at, 0, 0);
        if (cell && !*cell)
            *cell = (int)into + 1;
    }
    memory_free(covers);
}

static void measure_way(Measuring *measuring, const RuleWay *way) {
    for (size_t i = 0; i + 1 < way->count; i++) {
        double s = (double)i * WAYS_STEP;
        Vec2 at = way->at[i];
        CorridorWidth width = {.s = s};
        if (is_dead_end(measuring, way, at))
            continue;
        surroundings_look(&measuring->walls, at, CORRIDOR_WIDEST);
        surroundings_look(&measuring->near, at, CORRIDOR_WIDEST);
        PlaceKind kind = measure_place(measuring, at, vec2_unit(vec2_sub(way->at[i + 1], at)), &width);
        if (kind == PLACE_MEASURED) {
            measuring->run = memory_reserve(measuring->run, &measuring->run_capacity, measuring->run_count + 1,
                                            sizeof *measuring->run);
            measuring->run[measuring->run_count++] = width;
            measuring->wide_since = -1;
        } else if (kind == PLACE_WIDE && measuring->wide_since < 0) {
            measuring->wide_since = s;
        } else if (kind == PLACE_OPENING || (kind == PLACE_WIDE && s - measuring->wide_since > BRIDGED)) {
            end_run(measuring);
        }
    }
    end_run(measuring);
}

double corridor_width_between_rails(const CorridorWidth *width, double allowed) {
    double lost = 0;
    for (int k = 0; k < 2 && allowed > 0; k++)
        lost += fmax(width->rails[k] - allowed, 0);
    return width->width - lost;
}

size_t corridor_narrowest_between_rails(const Corridor *corridor, double allowed) {
    double least = HUGE_VAL;
    size_t equal = 0, k = 0, narrowest = 0;
    for (size_t i = 0; i < corridor->count; i++)
        least = fmin(least, corridor_width_between_rails(&corridor->widths[i], allowed));
    for (size_t i = 0; i < corridor->count; i++)
        equal += corridor_width_between_rails(&corridor->widths[i], allowed) <= least + EQUAL;
    for (size_t i = 0; i < corridor->count; i++)
        if (corridor_width_between_rails(&corridor->widths[i], allowed) <= least + EQUAL && k++ == equal / 2)
            narrowest = i;
    return narrowest;
}

/* Lists which pieces are rails. */
static bool *list_rails(const Plan *plan) {
    bool *rails = memory_zeroed(plan->furniture_count + 1, sizeof *rails);
    for (size_t f = 0; f < plan->furniture_count; f++)
        rails[f] = strcasestr(plan->furniture[f].name, "rail") || strcasestr(plan->furniture[f].id, "rail");
    return rails;
}

Corridors corridor_measure_all(const House *house, const Outline *walls, const RuleWays *ways) {
    Box box = house->outline.box;
    Corridors corridors = {.origin = box.low};
    corridors.cell = fmax(CELL, sqrt(fmax(box_width(box), 0) * fmax(box_height(box), 0) / LARGEST));
    corridors.nx = (int)(fmax(box_width(box), 0) / corridors.cell) + 1;
    corridors.ny = (int)(fmax(box_height(box), 0) / corridors.cell) + 1;
    corridors.covered = memory_zeroed((size_t)corridors.nx * (size_t)corridors.ny, sizeof *corridors.covered);
    bool *rails = list_rails(&house->plan);
    Measuring measuring = {.house = house,
                           .walls = {.outline = walls},
                           .near = {.outline = &house->outline, .rails = rails},
                           .corridors = &corridors,
                           .doors_of_room = memory_zeroed(house->plan.room_count + 1, sizeof(size_t)),
                           .exits_of_room = memory_zeroed(house->plan.room_count + 1, sizeof(bool)),
                           .furnished = HUGE_VAL,
                           .wide_since = -1};
    count_openings(&measuring);
    for (size_t w = 0; w < ways->count; w++)
        measure_way(&measuring, &ways->ways[w]);
    for (size_t c = 0; c < corridors.count; c++) {
        Corridor *corridor = &corridors.list[c];
        corridor->narrowest = corridor_narrowest_between_rails(corridor, 0);
        corridor->room = ways_room(&house->plan, corridor->widths[corridor->narrowest].at);
    }
    memory_free(measuring.doors_of_room);
    memory_free(measuring.exits_of_room);
    memory_free(measuring.run);
    memory_free(rails);
    surroundings_clear(&measuring.walls);
    surroundings_clear(&measuring.near);
    return corridors;
}

void corridor_free_all(Corridors *corridors) {
    for (size_t c = 0; c < corridors->count; c++)
        memory_free(corridors->list[c].widths);
    memory_free(corridors->list);
    memory_free(corridors->covered);
    *corridors = (Corridors){0};
}

double corridor_narrow_stretch(const Corridor *corridor, double least, double allowed) {
    double longest = 0, since = -1, last = -1;
    for (size_t i = 0; i < corridor->count; i++) {
        const CorridorWidth *width = &corridor->widths[i];
        bool goes_on = since >= 0 && width->s > last && width->s - last < BESIDE;
        if (corridor_width_between_rails(width, allowed) >= least) {
            since = -1;
            continue;
        }
        since = goes_on ? since : width->s;
        last = width->s;
        longest = fmax(longest, last - since);
    }
    return longest;
}
