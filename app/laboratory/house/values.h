/* The parameters of a house that can be changed while it is displayed: their values in the file and now. */
#pragma once

#include "house/house.h"
#include "laboratory/house/session.h"

/* The item or profile of a row. */
typedef struct ValueOwner {
    Item item;           /* item of the plan; none: the row belongs to the run or to a profile */
    const char *profile; /* name of the profile, or NULL */
    bool key;            /* one of the main parameters */
} ValueOwner;

/* A zeroed list is empty. */
typedef struct HouseValues {
    PanelParameter *rows; /* (count) in a fixed order */
    ValueOwner *owners;   /* (count) */
    size_t count, capacity, owner_capacity;
    PanelParameter *listed; /* (count) the same rows, those of the selection first */
    Arena arena;
} HouseValues;

/* Lists all values of a house; the list does not refer to the house. house_value_clear releases the list. */
void house_value_list(HouseValues *values, const House *house);
void house_value_clear(HouseValues *values);

/* Takes the values of one item from a plan, which may be newer than the house of the list. */
void house_value_follow(HouseValues *values, const Plan *plan, Item item);

/* Sorts `listed` for the present selection. */
void house_value_sort(HouseValues *values, const House *house, Item selected);

/* Returns the row with this name; SIZE_MAX: none. */
size_t house_value_find(const HouseValues *values, const char *name);

/* Rebuilds the list of values; rows that are also in `opened` keep their initial values and slider ranges. */
void house_value_rebuild(HouseValues *values, const HouseValues *opened, const House *house);

/* Sets a value; false: the fault says which values are allowed. */
bool house_value_set(HouseValues *values, size_t row, double value, Fault *fault);

/* Writes NAME=VALUE for each value that differs from the opening; returns their number. The texts belong to the
 * arena; `settings` must have room for all values. */
size_t house_value_settings(const HouseValues *values, const char **settings, Arena *arena);
