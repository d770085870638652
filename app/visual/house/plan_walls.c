#include "visual/house/plan_walls.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan.h"

static void clear_bands(PlanWalls *walls) {
    for (size_t i = 0; i < walls->count; i++)
        outline_free_rings(&walls->bands[i].rings);
    walls->count = 0;
}

void plan_walls_clear(PlanWalls *walls) {
    clear_bands(walls);
    memory_free(walls->bands);
    memory_free(walls->key);
    *walls = (PlanWalls){0};
}

/* Adds a number to the key; true: it differs from the old key's number there. */
static bool differs(PlanWalls *walls, size_t *at, double number) {
    bool other = *at >= walls->key_count || memcmp(&walls->key[*at], &number, sizeof number) != 0;
    walls->key = memory_reserve(walls->key, &walls->key_capacity, *at + 1, sizeof *walls->key);
    walls->key[(*at)++] = number;
    return other;
}

/* Replaces the key; true: it is another one. The numbers are those that outline_walls reads. */
static bool replace_key(PlanWalls *walls, const Plan *plan, double cut) {
    size_t at = 0;
    bool other = differs(walls, &at, cut);
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        other |= differs(walls, &at, (double)wall->points.count);
        for (size_t i = 0; i < wall->points.count; i++) {
            other |= differs(walls, &at, wall->points.at[i].x);
            other |= differs(walls, &at, wall->points.at[i].y);
        }
        other |= differs(walls, &at, wall->thickness);
        other |= differs(walls, &at, wall->height);
    }
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        const double numbers[] = {(double)door->wall_index, door->segment, door->at, door->width, door->state};
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
            other |= differs(walls, &at, numbers[i]);
    }
    other |= at != walls->key_count;
    walls->key_count = at;
    return other;
}

/* Adds the walls from height `low` up to less than `high`, m. */
static void add_band(PlanWalls *walls, const Plan *plan, double low, double high, double shown) {
    WallBand band = {.shown = shown};
    if (!outline_walls(plan, low, high, &band.rings) || !band.rings.count) {
        outline_free_rings(&band.rings);
        return;
    }
    walls->bands = memory_reserve(walls->bands, &walls->capacity, walls->count + 1, sizeof *walls->bands);
    walls->bands[walls->count++] = band;
}

/* Returns the least height of a wall from `low` m on, or the cut. */
static double next_height(const Plan *plan, double low, double cut) {
    double next = cut;
    for (size_t w = 0; w < plan->wall_count; w++)
        if (plan->walls[w].height >= low)
            next = fmin(next, plan->walls[w].height);
    return next;
}

bool plan_walls_update(PlanWalls *walls, const Plan *plan, double cut) {
    if (!replace_key(walls, plan, cut))
        return false;
    clear_bands(walls);
    double low = next_height(plan, 0, cut);
    for (; low < cut; low = next_height(plan, nextafter(low, HUGE_VAL), cut))
        add_band(walls, plan, low, nextafter(low, HUGE_VAL), low);
    add_band(walls, plan, low, HUGE_VAL, cut);
    return true;
}
