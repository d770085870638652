/* How far a house was changed since a lesson began: differences of two plans, element by element, by their ids.
 *
 *     change.doors_wider       m, by which doors were widened, added up
 *     change.doors             doors that were changed, added or removed
 *     change.furniture_moved   m, by which pieces were moved, added up
 *     change.furniture         pieces that were changed in any way, added or removed
 *     change.not_doors         changed elements of all other kinds than doors, and doors changed beside their width
 *     change.not_furniture     changed elements of all other kinds than furniture
 *     change.count             all changed elements */
#pragma once

#include "plan/plan.h"

/* Returns the unit of a difference, or NULL if there is none of that name. */
const char *difference_unit(const char *name);

/* Returns its value; the name must be known. */
double difference_value(const char *name, const Plan *before, const Plan *now);

/* Returns all names. */
const char *const *difference_names(size_t *count);
