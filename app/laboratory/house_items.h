/* The items of a house that can be picked: people, dangerous points, doors, furniture, walls and exits. If the
 * observation is NULL there are no dangerous points. */
#pragma once

#include "house/house.h"
#include "house/observation.h"
#include "laboratory/laboratory.h"
#include "visual/house/trail.h"

/* The kinds of items, in the order in which Tab visits them. */
typedef enum HouseItem {
    HOUSE_NOTHING,
    HOUSE_PERSON,
    HOUSE_HAZARD,
    HOUSE_DOOR,
    HOUSE_FURNITURE,
    HOUSE_WALL,
    HOUSE_EXIT,
    HOUSE_STOP, /* the place where a person is stopped; not visited by Tab */
    HOUSE_ITEMS,
} HouseItem;

/* The heading on the panel above the pieces that stop people in earthquakes. */
#define HOUSE_FIX_HEADING "What to fix to the wall"

enum { HOUSE_ITEM_NAME = 128 /* characters of an item's name */ };

size_t house_item_count(const House *house, const Observation *observation, int kind);

/* Returns the id as in the house file; "" for a dangerous point. */
const char *house_item_id(const House *house, Item item);

/* Finds the item with this id; kind 0: there is none. */
Item house_item_find(const House *house, int kind, const char *id);

/* Write "bedroom door", "wardrobe", "tight place 1: bedroom door"; the second one for the part of a wall that is
 * nearest to a place, m: "wall between bedroom and corridor". */
void house_item_name(const House *house, const Observation *observation, Item item, char *name, size_t size);
void house_item_name_at(const House *house, const Observation *observation, Item item, Vec2 at, char *name,
                        size_t size);

/* The house and its people's places over time: trails (person_count) belong to the observation. */
typedef struct HouseScenery {
    const House *house;
    const Observation *observation;
    const Trail *trails;
} HouseScenery;

/* Returns the door, piece of furniture, wall or exit of a plan with an id; kind 0: none. */
Item house_item_in(const Plan *plan, int kind, const char *id);

/* Fills in the outline of a door, a piece of furniture, a wall or an exit of a plan, and returns the number of points,
 * up to LABORATORY_OUTLINE_MOST; 0: of another kind. */
size_t house_item_outline_in(const Plan *plan, Item item, Vec2 *points);

/* As outline, pick and next of a Laboratory. */
size_t house_item_outline(const HouseScenery *scenery, Item item, double time, Vec2 *points);
Item house_item_at(const HouseScenery *scenery, Vec2 at, double time, Item below);
Item house_item_next(const HouseScenery *scenery, Item item, int step);

/* Returns the worst dangerous point of a tight place, whose index is that of its item. */
const Hazard *house_item_hazard(const House *house, const Observation *observation, size_t place);

/* Writes the kind and id of an item, "door d2", as files have it; house_item_name writes its name. */
void house_item_key(const House *house, const Observation *observation, Item item, char *key, size_t size);
