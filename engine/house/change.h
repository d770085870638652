/* The plan changes while people are in the house: people, doors and exits are known again by their ids, the world goes
 * on in the new house from where everybody is, and ways are planned anew from there. */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#include "house/journey.h"
#include "house/world.h"

/* What has become of whom. Each is an index in the other house, or SIZE_MAX: new, or gone. */
typedef struct Change {
    const House *from, *to; /* not owned */
    size_t *person_before;  /* (to->person_count) */
    size_t *person_after;   /* (from->person_count) */
    size_t *door_before;    /* (doors of `to`) */
    size_t *exit_after;     /* (exits of `from`) */
} Change;

/* change_clear releases what is filled; the houses must outlive it. */
void change_init(Change *change, const House *from, const House *to);
void change_clear(Change *change);

/* Moves a world between two of its steps into the changed house. Person i of it takes part when part[i]. The journeys,
 * the world's, are released and planned anew. Once `stop` is set nobody finds a way, and the world must not move any
 * more. What is kept of whom is said in run.h. */
void change_world(World *world, Journeys *journeys, const Change *change, const bool *part, int jobs,
                  const volatile sig_atomic_t *stop);
