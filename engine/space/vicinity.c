#include "space/vicinity.h"

#include <stdlib.h>

#include "base/memory.h"

enum {
    MOST_SQUARES = 1 << 21,
    MOST_ITEMS = 1 << 25, /* rather larger squares than more memory than this */
};

/* m: of a square, where the house is not too large for it */
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

/* False: too many items at this side. */
static bool list_squares(Vicinity *vicinity, const Outline *outline) {
    size_t squares = (size_t)vicinity->nx * (size_t)vicinity->ny;
    Listing listing = {.outline = outline, .reach = vicinity->reach + vicinity->side * M_SQRT1_2};
    vicinity->begin = memory_zeroed(squares + 1, sizeof *vicinity->begin);
    for (size_t s = 0; s < squares && listing.count <= MOST_ITEMS; s++) {
        size_t before = listing.count;
        double x = (double)(s % (size_t)vicinity->nx) + 0.5, y = (double)(s / (size_t)vicinity->nx) + 0.5;
        listing.centre = vec2_add(vicinity->low, vec2(x * vicinity->side, y * vicinity->side));
        broadphase_visit(outline->broadphase, box_around(listing.centre, listing.reach), list_item, &listing);
        if (listing.count > before)
            qsort(listing.items + before, listing.count - before, sizeof *listing.items, compare_items);
        vicinity->begin[s + 1] = (uint32_t)listing.count;
    }
    vicinity->items = listing.items;
    if (listing.count <= MOST_ITEMS)
        return true;
    memory_free(vicinity->begin);
    memory_free(vicinity->items);
    return false;
}

void vicinity_init(Vicinity *vicinity, const Outline *outline, const Plan *plan, double reach) {
    *vicinity = (Vicinity){.face_count = outline->face_count, .corner_count = outline->corner_count, .reach = reach};
    size_t features = outline->face_count + outline->corner_count;
    vicinity->faces = memory_zeroed(outline->face_count, sizeof *vicinity->faces);
    vicinity->corners = memory_zeroed(outline->corner_count, sizeof *vicinity->corners);
    vicinity->presence = memory_zeroed(features, sizeof *vicinity->presence);
    vicinity->door = memory_zeroed(features, sizeof *vicinity->door);
    for (size_t i = 0; i < outline->face_count; i++) {
        vicinity->faces[i] = neighbour_list_face(outline, plan, i);
        vicinity->presence[i] = (signed char)outline->faces[i].presence;
        vicinity->door[i] = outline->faces[i].door;
    }
    for (size_t i = 0; i < outline->corner_count; i++) {
        vicinity->corners[i] = neighbour_list_corner(outline, i);
        vicinity->presence[outline->face_count + i] = (signed char)outline->corners[i].presence;
        vicinity->door[outline->face_count + i] = outline->corners[i].door;
    }
    Box box = box_expand(outline->box, reach);
    double width = box_width(box), height = box_height(box);
    vicinity->low = box.low;
    vicinity->side = fmax(SIDE, sqrt(width * height / MOST_SQUARES));
    do {
        vicinity->nx = (int)fmin(width / vicinity->side, MOST_SQUARES) + 1;
        vicinity->ny = (int)fmin(height / vicinity->side, MOST_SQUARES) + 1;
        if ((double)vicinity->nx * vicinity->ny <= 2.0 * MOST_SQUARES && list_squares(vicinity, outline))
            return;
        vicinity->side *= 2;
    } while (true);
}

void vicinity_clear(Vicinity *vicinity) {
    memory_free(vicinity->begin);
    memory_free(vicinity->items);
    memory_free(vicinity->faces);
    memory_free(vicinity->corners);
    memory_free(vicinity->presence);
    memory_free(vicinity->door);
    *vicinity = (Vicinity){0};
}
