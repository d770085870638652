/* What of a house can be pointed at: people, dangerous points, doors, furniture, walls and exits. An observation that
 * is NULL has no dangerous points. */
#pragma once

#include "house/house.h"
#include "house/observation.h"
#include "live/house/house_live.h"
#include "visual/house/trail.h"

enum { HOUSE_THING_NAME = 128 /* room for a name */ };

size_t house_live_thing_count(const House *house, const Observation *observation, int kind);

/* As in the house file; "" for a dangerous point. */
const char *house_live_thing_id(const House *house, LiveThing thing);

/* What is called so, kind 0: nothing. */
LiveThing house_live_thing_find(const House *house, int kind, const char *id);

/* "door d2", "wardrobe (f3)", "dangerous point 1: door d2" */
void house_live_thing_name(const House *house, const Observation *observation, LiveThing thing, char *name,
                           size_t size);

/* People who stand somewhere at a time: trails (person_count) are the observation's. */
typedef struct HouseScenery {
    const House *house;
    const Observation *observation;
    const Trail *trails;
} HouseScenery;

/* As live->outline, live->pick and live->next. */
size_t house_live_thing_outline(const HouseScenery *scenery, LiveThing thing, double time, Vec2 *points);
LiveThing house_live_thing_at(const HouseScenery *scenery, Vec2 at, double time, LiveThing below);
LiveThing house_live_thing_next(const HouseScenery *scenery, LiveThing thing, int step);
