#include "rules/places.h"

#include <math.h>
#include <stdint.h>

#include "rules/surroundings.h"

static const double SAME_DIRECTION = 0.002; /* 1, difference of two directions that count as one */
static const double WITHIN = 0.05;          /* m, from the corners of a square: there it must be in a room */
static const double OUTSIDE_CELL = 0.01;    /* m: smaller cells of squares outside the rooms are not divided */

enum { DIRECTIONS = 4, PLACES_EACH = 10 /* steps of a way */ };

/* Squares of one direction over one place of a way. */
typedef struct Looking {
    const House *house;
    Vec2 axis;
    double need; /* m, half the side */
    Vec2 *cells; /* (count) middles */
    double *halves;
    size_t count, cell_capacity, half_capacity;
} Looking;

/* True if a square is within the rooms, or within the walls of a plan that has no rooms. */
static bool is_indoors(const Looking *looking, Vec2 at) {
    const Plan *plan = &looking->house->plan;
    double half = looking->need - WITHIN;
    for (int k = 0; k < 4; k++) {
        Vec2 corner = vec2(k & 1 ? half : -half, k & 2 ? half : -half);
        Vec2 place = vec2_add(at, vec2_turn(corner, looking->axis));
        if (plan->room_count ? ways_room(plan, place) == SIZE_MAX : !box_holds(looking->house->outline.box, place))
            return false;
    }
    return true;
}

static void push(Looking *looking, Vec2 at, double half) {
    size_t count = looking->count + 1;
    looking->cells = memory_reserve(looking->cells, &looking->cell_capacity, count, sizeof *looking->cells);
    looking->halves = memory_reserve(looking->halves, &looking->half_capacity, count, sizeof *looking->halves);
    looking->cells[looking->count] = at;
    looking->halves[looking->count++] = half;
}

/* True if a square of this direction is free over a place. */
static bool holds_square(Looking *looking, Vec2 over) {
    double reach = looking->need + TURNING_RESOLUTION;
    looking->count = 0;
    push(looking, over, looking->need);
    while (looking->count) {
        Vec2 at = looking->cells[--looking->count];
        double cell = looking->halves[looking->count];
        double half = freespace_growth(&looking->house->space, at, looking->axis, 0, 0, reach, NULL);
        if (half >= looking->need && is_indoors(looking, at))
            return true;
        bool outside = half >= looking->need && cell < OUTSIDE_CELL;
        if (outside || half + cell < looking->need + TURNING_RESOLUTION / 2)
            continue;
        for (int k = 0; k < 4; k++) {
            Vec2 by = vec2(k & 1 ? cell / 2 : -cell / 2, k & 2 ? cell / 2 : -cell / 2);
            push(looking, vec2_add(at, vec2_turn(by, looking->axis)), cell / 2);
        }
    }
    return false;
}

/* Fills in the directions of walls near a place, each within a quarter turn; without a wall, the direction of x. */
static int directions_near(Surroundings *near, Vec2 at, double reach, Vec2 axes[DIRECTIONS]) {
    int count = 0;
    surroundings_look(near, at, reach);
    for (size_t i = 0; i < near->count && count < DIRECTIONS; i++) {
        const Face *face = surroundings_face(near, i, SEE_WALLS, -1);
        bool known = !face;
        for (int k = 0; k < count && !known; k++)
            known = fabs(vec2_dot(face->normal, axes[k])) < SAME_DIRECTION ||
                    fabs(vec2_cross(face->normal, axes[k])) < SAME_DIRECTION;
        if (!known)
            axes[count++] = face->normal;
    }
    if (!count)
        axes[count++] = vec2(1, 0);
    return count;
}

Places places_find(const House *house, const RuleWays *ways, double side, const Stop *stop) {
    Places places = {.way_count = ways->count};
    Surroundings near = {.outline = &house->outline};
    Looking looking = {.house = house, .need = side / 2};
    places.at = memory_zeroed(ways->count + 1, sizeof *places.at);
    places.count = memory_zeroed(ways->count + 1, sizeof *places.count);
    for (size_t w = 0; w < ways->count; w++) {
        const RuleWay *way = &ways->ways[w];
        places.count[w] = (way->count + PLACES_EACH - 1) / PLACES_EACH;
        places.at[w] = memory_zeroed(places.count[w] + 1, sizeof **places.at);
        for (size_t i = 0; i < places.count[w] && !places.interrupted; i++) {
            Vec2 axes[DIRECTIONS], at = way->at[i * PLACES_EACH];
            int count = directions_near(&near, at, side, axes);
            for (int k = 0; k < count && !places.at[w][i]; k++) {
                looking.axis = axes[k];
                places.at[w][i] = holds_square(&looking, at);
            }
            places.interrupted = stop_requested(stop);
        }
    }
    surroundings_clear(&near);
    memory_free(looking.cells);
    memory_free(looking.halves);
    return places;
}

void places_free(Places *places) {
    for (size_t w = 0; w < places->way_count; w++)
        memory_free(places->at[w]);
    memory_free(places->at);
    memory_free(places->count);
    *places = (Places){0};
}

PlacesStretch places_stretch(const Places *places, const RuleWays *ways, const Corridors *corridors, size_t corridor) {
    PlacesStretch stretch = {0};
    for (size_t w = 0; w < places->way_count; w++) {
        const RuleWay *way = &ways->ways[w];
        size_t count = places->count[w], last = 0; /* the last place, or the beginning */
        bool begun = false, through = false;       /* a place was met; the stretch leads through the corridor */
        for (size_t i = 0; i < count; i++) {
            bool here = places->at[w][i], end = i + 1 == count;
            bool inside = corridor_at(corridors, way->at[i * PLACES_EACH]) == corridor;
            through |= inside;
            bool on = begun && here && i - last == 1; /* from place to place */
            double length = on ? 0 : (double)((i - last) * PLACES_EACH) * WAYS_STEP;
            if (through && (here || end)) {
                stretch.any |= begun || here;
                if (length > stretch.longest) {
                    stretch.longest = length;
                    stretch.from = way->at[last * PLACES_EACH];
                    stretch.to = way->at[i * PLACES_EACH];
                }
            }
            if (!here)
                continue;
            last = i;
            begun = true;
            through = inside;
        }
    }
    return stretch;
}
