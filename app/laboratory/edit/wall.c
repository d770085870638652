/* Draws walls: a chain of points becomes one wall per run of equal thickness. */
#include <stdio.h>

#include "laboratory/edit/editor_state.h"

static json_t *points_of(const Vec2 *points, size_t count) {
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(list, json_pack("[o, o]", json_number(points[i].x), json_number(points[i].y)));
    return list;
}

static void add_wall(Editor *edit, const Vec2 *points, size_t count, double thickness) {
    if (count < 2)
        return;
    json_t *element = json_pack("{s:o, s:o}", "points", points_of(points, count), "thickness", json_number(thickness));
    snprintf(edit->made, EDIT_NAME, "%s", draft_add(edit->draft, DRAFT_WALLS, element));
}

void edit_wall_make(Editor *edit) {
    const EditChain *chain = &edit->chain;
    size_t count = chain->count + chain->floating, first = 0;
    Vec2 *points = memory_zeroed(count, sizeof *points);
    for (size_t i = 0; i < count; i++)
        points[i] = i < chain->count ? chain->points[i] : edit->now.at;
    for (size_t i = 1; i < count; i++) { /* each segment has the thickness of its second point */
        double thickness = i < chain->count ? chain->amount[i] : edit->now.amount;
        double next = i + 1 < chain->count ? chain->amount[i + 1] : i + 1 < count ? edit->now.amount : -1;
        if (thickness == next)
            continue;
        add_wall(edit, points + first, i + 1 - first, thickness);
        first = i;
    }
    memory_free(points);
}
