/* Places for turning along the ways: free squares of a given side over the way itself.
 *
 * A square lies in the direction of a wall nearby, within the rooms of the plan (of a plan without rooms: within its
 * walls), since what lies beyond an exit is not in the plan. A stretch without a place goes from one place to the next,
 * or to the beginning or the end of the way.
 *
 * Numerics: the way is looked at each 0.1 m, which is how exact the length of a stretch is; squares are found to
 * TURNING_RESOLUTION, by branch and bound as in turning.h. */
#pragma once

#include "rules/corridor.h"
#include "rules/turning.h"

#define PLACES_LARGEST (2 * FREESPACE_FARTHEST) /* m, side of the largest square that can be looked for */

typedef struct Places {
    bool **at;     /* (way_count) of each way, each 0.1 m: there is a square */
    size_t *count; /* (way_count) */
    size_t way_count;
    bool interrupted;
} Places;

/* The longest stretch of a way in a corridor that has no place. */
typedef struct PlacesStretch {
    double longest; /* m; 0: there are places all along */
    bool any;       /* True if a place is in the corridor or at an end of a stretch that leads through it */
    Vec2 from, to;  /* m, ends of the longest one */
} PlacesStretch;

/* Finds the squares whose side is at least `side` m. places_free releases them. */
Places places_find(const House *house, const RuleWays *ways, double side, const Stop *stop);
void places_free(Places *places);

PlacesStretch places_stretch(const Places *places, const RuleWays *ways, const Corridors *corridors, size_t corridor);
