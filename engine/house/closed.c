#include "house/closed.h"

#include <pthread.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"

/* A layout, or that there is none. */
typedef struct Known {
    double since; /* s */
    ClosedLayout *layout;
} Known;

struct ClosedLayouts {
    pthread_mutex_t lock;
    Known *all; /* (count) */
    size_t count, capacity;
};

/* True if the line of an exit that has closed by `since` bars the way from then on: no exit with another time lies on
 * it. */
static bool is_barred(const Plan *plan, size_t exit, double since) {
    if (plan->exits[exit].closes > since)
        return false;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan->exits[e].closes > since && plan_geometry_covers(&plan->exits[e], &plan->exits[exit]))
            return false;
    return true;
}

/* Layouts -----------------------------------------------------------------------------------------------------------*/

ClosedLayouts *closed_layouts_create(void) {
    ClosedLayouts *layouts = memory_zeroed(1, sizeof *layouts);
    pthread_mutex_init(&layouts->lock, NULL);
    return layouts;
}

static void layout_free(ClosedLayout *layout) {
    if (layout->fields)
        fields_destroy(layout->fields);
    freespace_free(&layout->space);
    outline_free(&layout->outline);
    arena_clear(&layout->plan.arena);
    memory_free(layout);
}

void closed_layouts_destroy(ClosedLayouts *layouts) {
    if (!layouts)
        return;
    for (size_t i = 0; i < layouts->count; i++)
        if (layouts->all[i].layout)
            layout_free(layouts->all[i].layout);
    memory_free(layouts->all);
    pthread_mutex_destroy(&layouts->lock);
    memory_free(layouts);
}

/* Gives the plan's copy the lines as walls, after its own, so that doors keep their walls. */
static void add_walls(Plan *plan, double since) {
    Wall *walls = arena_allocate(&plan->arena, (plan->wall_count + plan->exit_count) * sizeof *walls);
    if (plan->wall_count)
        memcpy(walls, plan->walls, plan->wall_count * sizeof *walls);
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        if (!is_barred(plan, e, since))
            continue;
        Vec2 *ends = arena_allocate(&plan->arena, 2 * sizeof *ends);
        ends[0] = exit->from;
        ends[1] = exit->to;
        walls[plan->wall_count++] = (Wall){.id = exit->id, .points = {ends, 2}, .closed_exit = true};
    }
    plan->walls = walls;
}

static ClosedLayout *build(const House *house, double since) {
    ClosedLayout *layout = memory_zeroed(1, sizeof *layout);
    layout->plan = house->plan;
    layout->plan.arena = (Arena){0};
    add_walls(&layout->plan, since);
    Fault fault = {0};
    bool good = outline_build(&layout->outline, &layout->plan, &fault);
    fault_clear(&fault);
    if (!good) {
        layout_free(layout);
        return NULL;
    }
    freespace_build(&layout->space, &layout->outline, layout->plan.run.cell);
    layout->fields = fields_create();
    return layout;
}

const ClosedLayout *closed_layout(ClosedLayouts *layouts, const House *house, double since) {
    pthread_mutex_lock(&layouts->lock); /* threads that need the same layout wait for it */
    size_t found = 0;
    while (found < layouts->count && (layouts->all[found].since < since || layouts->all[found].since > since))
        found++;
    if (found == layouts->count) {
        layouts->all = memory_reserve(layouts->all, &layouts->capacity, layouts->count + 1, sizeof *layouts->all);
        layouts->all[layouts->count++] = (Known){since, build(house, since)};
    }
    const ClosedLayout *layout = layouts->all[found].layout;
    pthread_mutex_unlock(&layouts->lock);
    return layout;
}

/* Ways across the lines ---------------------------------------------------------------------------------------------*/

size_t closed_between(const Plan *plan, double since, Vec2 from, Vec2 to) {
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        if (exit->closes <= since && plan_geometry_side(exit, from) != 0 && plan_geometry_leads_out(exit, from, to) &&
            is_barred(plan, e, since))
            return e;
    }
    return SIZE_MAX;
}

size_t closed_on_route(const Plan *plan, double since, const Route *route) {
    size_t exit = SIZE_MAX;
    for (size_t p = 0; p + 1 < route->count && exit == SIZE_MAX; p++)
        exit = closed_between(plan, since, route->poses[p].at, route->poses[p + 1].at);
    return exit;
}

bool closed_on_track(const Plan *plan, double since, const Track *track, size_t first) {
    for (size_t p = first; p + 1 < track->count; p++)
        if (closed_between(plan, since, track->points[p].at, track->points[p + 1].at) != SIZE_MAX)
            return true;
    return false;
}

/* True if paths of the field lead from one side of the line to the other: the time falls across it. */
static bool leads_across(const FloorField *field, const Exit *exit) {
    Vec2 line = vec2_sub(exit->to, exit->from), along = vec2_unit(line), across = vec2_left(along);
    double length = vec2_length(line), aside = 2 * field->cell;
    for (double s = field->cell / 2; s < length; s += field->cell)
        for (int side = -1; side <= 1; side += 2) {
            Vec2 on = vec2_along(exit->from, s, along), before = vec2_along(on, -side * aside, across);
            Vec2 direction = floor_field_direction(field, before);
            bool towards = side * vec2_dot(direction, across) > 0;
            if (towards &&
                floor_field_time(field, vec2_along(on, side * aside, across)) < floor_field_time(field, before))
                return true;
        }
    return false;
}

bool closed_on_field(const Plan *plan, double after, double since, const FloorField *field) {
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan->exits[e].closes > after && is_barred(plan, e, since) && leads_across(field, &plan->exits[e]))
            return true;
    return false;
}
