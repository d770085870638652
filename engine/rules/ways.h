/* The ways on which a house is measured: from where each person of the plan begins, and from each door that can be
 * passed, the shortest way of a thin disc to an exit. A disc gets through where a chair does not, so that a place is
 * measured whether or not anybody can pass it.
 *
 * Numerics: the disc has a radius of 0.15 m, and places lie 1 cm apart; a clear width that is measured across the way
 * depends on neither. */
#pragma once

#include <stddef.h>

#include "base/stop.h"
#include "house/house.h"

#define WAYS_STEP 0.01 /* m, between places */

typedef struct RuleWay {
    Vec2 *at; /* (count) WAYS_STEP apart; the last step is shorter */
    size_t count;
    size_t person; /* index in the house; SIZE_MAX: it begins at a door */
    size_t room;   /* index of the room in which it begins; SIZE_MAX: none */
} RuleWay;

typedef struct RuleWays {
    RuleWay *ways; /* (count) people first */
    size_t count;
    bool interrupted;
} RuleWays;

/* Finds the ways; who cannot reach an exit has none. ways_free releases them. */
RuleWays ways_find(const House *house, const Stop *stop);
void ways_free(RuleWays *ways);

/* Returns the index of the room in whose outline a place lies, or SIZE_MAX. */
size_t ways_room(const Plan *plan, Vec2 at);

/* True if two segments have a point in common. */
bool ways_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/* True if a place lies in the opening of a door, or up to `beside` m before it or beside it. */
bool ways_in_opening(const Plan *plan, Vec2 at, double beside);
