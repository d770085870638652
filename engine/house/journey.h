/* What everybody intends before the house begins to move: a route, and how to follow it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "house/house.h"
#include "house/route.h"
#include "house/track.h"

/* What is planned for one person before the world moves. */
typedef struct Journey {
    Route route;
    Track track; /* empty when there is no way */
} Journey;

/* Plans everybody's journey, on up to `jobs` threads, until `stop` (may be NULL) is set; person i takes part when
 * `part` is NULL or part[i]. The array has house->person_count elements; journey_free_all releases it. */
Journey *journey_plan_all(const House *house, const bool *part, int jobs, const volatile sig_atomic_t *stop);
void journey_free_all(Journey *journeys, size_t count);
