#include "exchange/plan_size.h"

#include <math.h>

#include "base/real.h"
#include "base/text.h"

static const double LEAST = 3, MOST = 200;                                 /* m: range of the longer side of a plan */
static const double USUAL_LEAF = 0.85, USUAL_WALL = 0.13, USUAL_PLAN = 12; /* m */
static const double LEAF_SPREAD = 0.15, WALL_SPREAD = 0.5, PLAN_SPREAD = 0.7; /* 1, of their logarithms: assumed */
static const double NO_WALL = 2; /* standard deviations that walls of no thickness count, where others have one */
static const double IMPOSSIBLE = 100;
static const double ROUNDING = 0.015; /* 1: a written length may be rounded by this share */

const PlanUnit plan_size_units[PLAN_SIZE_UNITS] = {
    {"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"inch", 0.0254}, {"ft", 0.3048}};

const PlanUnit *plan_size_unit_of(double length, double metres) {
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        if (length > 0 && fabs(metres / (length * plan_size_units[u].metres) - 1) < ROUNDING)
            return &plan_size_units[u];
    return NULL;
}

bool plan_size_is_plausible(double longer) {
    return longer >= LEAST && longer <= MOST;
}

/* Returns how far the sizes are from usual ones: the sum of squared deviations. */
static double oddness(const ImportUnit *unit) {
    double odd = unit->possible ? 0 : IMPOSSIBLE;
    double leaf = unit->leaf > 0 ? real_log(unit->leaf / USUAL_LEAF) / LEAF_SPREAD : 0;
    double wall = unit->wall > 0 ? real_log(unit->wall / USUAL_WALL) / WALL_SPREAD : NO_WALL;
    double longer = fmax(unit->plan.x, unit->plan.y),
           plan = longer > 0 ? real_log(longer / USUAL_PLAN) / PLAN_SPREAD : 0;
    return odd + leaf * leaf + wall * wall + plan * plan;
}

void plan_size_list(ImportReport *report, Vec2 size, double leaf, const double walls[PLAN_SIZE_UNITS]) {
    report->unit_count = 0;
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++) {
        double metres = plan_size_units[u].metres;
        ImportUnit unit = {.name = plan_size_units[u].name,
                           .metres = metres,
                           .plan = vec2_scale(size, metres),
                           .leaf = leaf * metres,
                           .wall = walls ? walls[u] : 0,
                           .possible = plan_size_is_plausible(fmax(size.x, size.y) * metres)};
        size_t i = report->unit_count++;
        for (; i > 0 && oddness(&unit) < oddness(&report->units[i - 1]); i--)
            report->units[i] = report->units[i - 1];
        report->units[i] = unit;
    }
}

bool plan_size_refuse(HouseBuilder *builder, const char *why, Vec2 size, const bool possible[PLAN_SIZE_UNITS]) {
    Text sizes = {0};
    bool any = false;
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        any |= possible[u];
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        if (possible[u] || !any)
            text_format(&sizes, "%.4g m by %.4g m in %s, ", size.x * plan_size_units[u].metres,
                        size.y * plan_size_units[u].metres, plan_size_units[u].name);
    if (!builder->report->unit_count)
        plan_size_list(builder->report, size, 0, NULL);
    house_builder_fail(builder, "%s: the plan would be %ssay --unit " IMPORT_UNITS, why, sizes.text);
    memory_free(sizes.text);
    return false;
}
