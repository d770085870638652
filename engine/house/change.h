/* Changes the plan while people are in the house: people, doors and exits are matched by id, the world continues in the
 * new house from the current positions, and paths are planned again from there. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "house/journey.h"
#include "house/world.h"

/* The correspondence of two houses. Each entry is an index in the other house, or SIZE_MAX for new or removed elements.
 */
typedef struct Change {
    const House *from, *to; /* not owned */
    size_t *person_before;  /* (to->person_count) */
    size_t *person_after;   /* (from->person_count) */
    size_t *door_before;    /* (doors of `to`) */
    size_t *exit_after;     /* (exits of `from`) */
} Change;

/* Matches two houses, which must outlive the change. change_clear releases it. */
void change_init(Change *change, const House *from, const House *to);
void change_clear(Change *change);

/* Moves a world between two of its steps into the changed house. Person i of that house takes part when part[i]. The
 * journeys of the world are released and planned again. Once `stop` is requested, no path is found, and the world must
 * not move any more. run.h says what each person keeps. */
void change_world(World *world, Journeys *journeys, const Change *change, const bool *part, int jobs, const Stop *stop);
