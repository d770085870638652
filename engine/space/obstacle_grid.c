#include "space/obstacle_grid.h"

#include <stdlib.h>

#include "base/memory.h"

enum {
    MOST_SQUARES = 1 << 21,
    MOST_ITEMS = 1 << 25, /* squares are made larger rather than exceed this number of items */
};

/* m: side of a square, unless the house is too large for it. */
static const double SIDE = 0.25;

typedef struct Listing {
    const Outline *outline;
    Vec2 centre;
    double reach; /* m, from the centre */
    uint32_t *items;
    size_t count, capacity;
} Listing;

static bool list_item(void *context, int item) {
    Listing *listing = context;
    const Outline *outline = listing->outline;
    Vec2 nearest = (size_t)item < outline->face_count
                       ? vec2_nearest_on_segment(listing->centre, outline->faces[item].a, outline->faces[item].b)
                       : outline->corners[(size_t)item - outline->face_count].at;
    if (vec2_distance(listing->centre, nearest) > listing->reach)
        return true;
    listing->items = memory_reserve(listing->items, &listing->capacity, listing->count + 1, sizeof *listing->items);
    listing->items[listing->count++] = (uint32_t)item;
    return true;
}

static int compare_items(const void *a, const void *b) {
    uint32_t p = *(const uint32_t *)a, q = *(const uint32_t *)b;
    return (p > q) - (p < q);
}

/* Lists the features of all squares. Returns false if there are too many items at this side length. */
static bool list_squares(ObstacleGrid *grid, const Outline *outline) {
    size_t squares = (size_t)grid->nx * (size_t)grid->ny;
    Listing listing = {.outline = outline, .reach = grid->reach + grid->side * M_SQRT1_2};
    grid->begin = memory_zeroed(squares + 1, sizeof *grid->begin);
    for (size_t s = 0; s < squares && listing.count <= MOST_ITEMS; s++) {
        size_t before = listing.count;
        double x = (double)(s % (size_t)grid->nx) + 0.5, y = (double)(s / (size_t)grid->nx) + 0.5;
        listing.centre = vec2_add(grid->low, vec2(x * grid->side, y * grid->side));
        broadphase_visit(outline->broadphase, box_around(listing.centre, listing.reach), list_item, &listing);
        if (listing.count > before)
            qsort(listing.items + before, listing.count - before, sizeof *listing.items, compare_items);
        grid->begin[s + 1] = (uint32_t)listing.count;
    }
    grid->items = listing.items;
    if (listing.count <= MOST_ITEMS)
        return true;
    memory_free(grid->begin);
    memory_free(grid->items);
    return false;
}

void obstacle_grid_init(ObstacleGrid *grid, const Outline *outline, const Plan *plan, double reach) {
    *grid = (ObstacleGrid){.face_count = outline->face_count, .corner_count = outline->corner_count, .reach = reach};
    size_t features = outline->face_count + outline->corner_count;
    grid->faces = memory_zeroed(outline->face_count, sizeof *grid->faces);
    grid->corners = memory_zeroed(outline->corner_count, sizeof *grid->corners);
    grid->presence = memory_zeroed(features, sizeof *grid->presence);
    grid->door = memory_zeroed(features, sizeof *grid->door);
    for (size_t i = 0; i < outline->face_count; i++) {
        grid->faces[i] = neighbour_list_face(outline, plan, i);
        grid->presence[i] = (signed char)outline->faces[i].presence;
        grid->door[i] = outline->faces[i].door;
    }
    for (size_t i = 0; i < outline->corner_count; i++) {
        grid->corners[i] = neighbour_list_corner(outline, i);
        grid->presence[outline->face_count + i] = (signed char)outline->corners[i].presence;
        grid->door[outline->face_count + i] = outline->corners[i].door;
    }
    Box box = box_expand(outline->box, reach);
    double width = box_width(box), height = box_height(box);
    grid->low = box.low;
    grid->side = fmax(SIDE, sqrt(width * height / MOST_SQUARES));
    do {
        grid->nx = (int)fmin(width / grid->side, MOST_SQUARES) + 1;
        grid->ny = (int)fmin(height / grid->side, MOST_SQUARES) + 1;
        if ((double)grid->nx * grid->ny <= 2.0 * MOST_SQUARES && list_squares(grid, outline))
            return;
        grid->side *= 2;
    } while (true);
}

void obstacle_grid_clear(ObstacleGrid *grid) {
    memory_free(grid->begin);
    memory_free(grid->items);
    memory_free(grid->faces);
    memory_free(grid->corners);
    memory_free(grid->presence);
    memory_free(grid->door);
    *grid = (ObstacleGrid){0};
}
