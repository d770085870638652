/* Units in which plans are drawn, and the sizes that plans have. Private to the importers. */
#pragma once

#include "exchange/house_builder.h"

typedef struct PlanUnit {
    const char *name;
    double metres;
} PlanUnit;

enum { PLAN_SIZE_UNITS = 5 };
extern const PlanUnit plan_size_units[PLAN_SIZE_UNITS];

/* Returns the unit in which the length `length` equals `metres`, within 1.5 %, or NULL. */
const PlanUnit *plan_size_unit_of(double length, double metres);

/* True if a plan may have this longer side (m). */
bool plan_size_is_plausible(double longer);

/* Lists in the report all units that a plan of this extent (unit of the file) may have: by the sizes of its doors,
 * walls and rooms, the likeliest first. `leaf` is in the file's unit, `walls` in m for each unit; 0 or NULL: unknown.
 */
void plan_size_list(ImportReport *report, Vec2 size, double leaf, const double walls[PLAN_SIZE_UNITS]);

/* Adds the error that the unit is doubtful: `size` is in the file's unit, `possible` are candidates, or all if none
 * is. `why` begins the sentence. Returns false. */
bool plan_size_refuse(HouseBuilder *builder, const char *why, Vec2 size, const bool possible[PLAN_SIZE_UNITS]);
