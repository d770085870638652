/* Obstacles that walkers may touch: for every square of the house, the faces and corners near it. The grid is built
 * once, since walls and furniture do not move and doors only change state. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/vec2.h"
#include "space/neighbour_list.h"
#include "space/outline.h"

typedef struct ObstacleGrid {
    Vec2 low;    /* m, of square (0, 0) */
    double side; /* m */
    int nx, ny;
    uint32_t *begin;          /* (nx * ny + 1) into items */
    uint32_t *items;          /* features: face i as i, corner j as face_count + j, rising */
    NeighbourFace *faces;     /* (face_count) */
    NeighbourCorner *corners; /* (corner_count) */
    signed char *presence;    /* (face_count + corner_count) Presence */
    int *door;                /* (as many) door whose state decides, or -1 */
    size_t face_count, corner_count;
    double reach; /* m, distance from a square within which features are listed for it */
} ObstacleGrid;

/* Lists the features within `reach` m of each square. A zeroed grid is empty; obstacle_grid_clear releases it. */
void obstacle_grid_init(ObstacleGrid *grid, const Outline *outline, const Plan *plan, double reach);
void obstacle_grid_clear(ObstacleGrid *grid);

/* Returns the features near a place, `*count` of them. */
static inline const uint32_t *obstacle_grid_at(const ObstacleGrid *grid, Vec2 at, size_t *count) {
    double x = (at.x - grid->low.x) / grid->side, y = (at.y - grid->low.y) / grid->side;
    *count = 0;
    if (!(x >= 0 && y >= 0 && x < grid->nx && y < grid->ny))
        return NULL;
    size_t square = (size_t)y * (size_t)grid->nx + (size_t)x;
    *count = grid->begin[square + 1] - grid->begin[square];
    return grid->items + grid->begin[square];
}

/* True if the feature is present in the current state of the doors. */
static inline bool obstacle_grid_has(const ObstacleGrid *grid, uint32_t item, const bool *door_open) {
    int presence = grid->presence[item];
    return presence == PRESENT_ALWAYS || door_open[grid->door[item]] == (presence == PRESENT_OPEN);
}
