#include "exchange/plan_size.h"

#include <math.h>

#include "base/text.h"

static const double LEAST = 3, MOST = 200; /* m: range of the longer side of a plan */
static const double ROUNDING = 0.015;      /* 1: a written length may be rounded by this share */

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

bool plan_size_refuse(HouseBuilder *builder, const char *why, Vec2 size, const bool possible[PLAN_SIZE_UNITS]) {
    Text sizes = {0};
    bool any = false;
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        any |= possible[u];
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        if (possible[u] || !any)
            text_format(&sizes, "%.4g m by %.4g m in %s, ", size.x * plan_size_units[u].metres,
                        size.y * plan_size_units[u].metres, plan_size_units[u].name);
    house_builder_fail(builder, "%s: the plan would be %ssay --unit " IMPORT_UNITS, why, sizes.text);
    memory_free(sizes.text);
    return false;
}
