#include "rules/turning.h"

#include <math.h>
#include <stdint.h>

#include "rules/ways.h"

static const double FIRST_CELL = 0.25;      /* m, largest half side of a cell at the beginning */
static const double SAME_DIRECTION = 0.002; /* 1, difference of two directions that count as one */

enum { DIRECTIONS = 8, CELLS_MOST = 4000000 };

typedef struct Cell {
    Vec2 at; /* m, its middle */
    double half;
} Cell;

typedef struct Search {
    const House *house;
    size_t room;
    bool square;
    Vec2 axis; /* of the cells, and of the square */
    Cell *cells;
    size_t count, capacity, looked_at;
    Cell *parts; /* (part_capacity) memory for the cells of the next size */
    size_t part_capacity;
    TurningPlace best;
} Search;

/* Returns half the size that is free round a place, m; negative inside solids. */
static double half_size(const Search *search, Vec2 at) {
    const FreeSpace *space = &search->house->space;
    if (search->square)
        return freespace_growth(space, at, search->axis, 0, 0, FREESPACE_FARTHEST, NULL);
    double distance = freespace_exact(space, at, FREESPACE_FARTHEST, NULL);
    return freespace_distance(space, at) < 0 ? -distance : distance;
}

static void push(Search *search, Vec2 at, double half) {
    search->cells = memory_reserve(search->cells, &search->capacity, search->count + 1, sizeof *search->cells);
    search->cells[search->count++] = (Cell){at, half};
}

/* True if no place within `reach` m belongs to the room. */
static bool is_outside(const Search *search, Vec2 at, double reach) {
    const Points *outline = &search->house->plan.rooms[search->room].outline;
    if (ways_room(&search->house->plan, at) == search->room)
        return false;
    for (size_t i = 0; i < outline->count; i++) {
        Vec2 nearest = vec2_nearest_on_segment(at, outline->at[i], outline->at[(i + 1) % outline->count]);
        if (vec2_distance(nearest, at) <= reach)
            return false;
    }
    return true;
}

static void look_at(Search *search, Cell cell) {
    double half = half_size(search, cell.at);
    bool better = 2 * half > search->best.size;
    if (better && is_outside(search, cell.at, cell.half * M_SQRT2))
        return;
    if (better && ways_room(&search->house->plan, cell.at) == search->room)
        search->best = (TurningPlace){2 * half, cell.at, search->axis};
    double bound = 2 * (half + cell.half * (search->square ? 1 : M_SQRT2));
    if (fmin(bound, 2 * FREESPACE_FARTHEST) <= search->best.size + TURNING_RESOLUTION)
        return;
    for (int k = 0; k < 4; k++) {
        Vec2 by = vec2(k & 1 ? cell.half / 2 : -cell.half / 2, k & 2 ? cell.half / 2 : -cell.half / 2);
        push(search, vec2_add(cell.at, vec2_turn(by, search->axis)), cell.half / 2);
    }
}

static void search_along(Search *search, Vec2 axis) {
    const Points *outline = &search->house->plan.rooms[search->room].outline;
    Box box = box_empty();
    search->axis = axis;
    search->count = search->looked_at = 0;
    for (size_t i = 0; i < outline->count; i++)
        box = box_include(box, vec2_unturn(outline->at[i], axis));
    double half = fmin(fmax(box_width(box), box_height(box)) / 2, FIRST_CELL);
    if (!(half > 0))
        return;
    for (double y = box.low.y + half; y < box.high.y + half; y += 2 * half)
        for (double x = box.low.x + half; x < box.high.x + half; x += 2 * half)
            push(search, vec2_turn(vec2(x, y), axis), half);
    /* The cells of one size are looked at before their parts, so that a large place is known early. */
    while (search->count && search->looked_at < CELLS_MOST) {
        Cell *cells = search->cells;
        size_t count = search->count, capacity = search->capacity;
        search->cells = search->parts;
        search->capacity = search->part_capacity;
        search->count = 0;
        for (size_t i = 0; i < count; i++)
            look_at(search, cells[i]);
        search->looked_at += count;
        search->parts = cells;
        search->part_capacity = capacity;
    }
}

/* Fills in the directions of walls in the room's box, each within a quarter turn. */
static int wall_directions(const House *house, size_t room, Vec2 axes[DIRECTIONS]) {
    const Points *outline = &house->plan.rooms[room].outline;
    Box box = box_empty();
    int count = 0;
    for (size_t i = 0; i < outline->count; i++)
        box = box_include(box, outline->at[i]);
    box = box_expand(box, 0.3);
    for (size_t f = 0; f < house->outline.face_count && count < DIRECTIONS; f++) {
        const Face *face = &house->outline.faces[f];
        if (face->owner != OWNER_WALL || (!box_holds(box, face->a) && !box_holds(box, face->b)))
            continue;
        bool known = false;
        for (int k = 0; k < count && !known; k++)
            known = fabs(vec2_dot(face->normal, axes[k])) < SAME_DIRECTION ||
                    fabs(vec2_cross(face->normal, axes[k])) < SAME_DIRECTION;
        if (!known)
            axes[count++] = face->normal;
    }
    return count;
}

TurningPlace turning_circle(const House *house, size_t room) {
    Search search = {.house = house, .room = room};
    search_along(&search, vec2(1, 0));
    memory_free(search.cells);
    memory_free(search.parts);
    return search.best;
}

TurningPlace turning_square(const House *house, size_t room) {
    Search search = {.house = house, .room = room, .square = true};
    Vec2 axes[DIRECTIONS] = {{1, 0}};
    int count = wall_directions(house, room, axes);
    for (int k = 0; k < (count ? count : 1); k++)
        search_along(&search, axes[k]);
    memory_free(search.cells);
    memory_free(search.parts);
    return search.best;
}
