/* The numbers of a house that can be changed while it is shown: which there are, what they are in the file and now. */
#pragma once

#include "house/house.h"
#include "laboratory/house/session.h"

/* The item or profile of a row. */
typedef struct ValueOwner {
    Item thing;          /* of the plan; none: of the run or of a profile */
    const char *profile; /* its name, or NULL */
    bool key;            /* of those that tell most */
} ValueOwner;

/* Zero is none. */
typedef struct HouseValues {
    PanelParameter *rows; /* (count) in a fixed order */
    ValueOwner *owners;   /* (count) */
    size_t count, capacity, owner_capacity;
    PanelParameter *listed; /* (count) the same rows, those of what is selected first */
    Arena arena;
} HouseValues;

/* Lists all values of a house, which the list does not need afterwards. house_value_clear releases them. */
void house_value_list(HouseValues *values, const House *house);
void house_value_clear(HouseValues *values);

/* Brings `listed` up to date. */
void house_value_sort(HouseValues *values, const House *house, Item selected);

/* The row called so; SIZE_MAX: none. */
size_t house_value_find(const HouseValues *values, const char *name);

/* Lists the values again; those in `opened` keep their initial values and slider ranges. */
void house_value_list_again(HouseValues *values, const HouseValues *opened, const House *house);

/* Sets a value; false: a fault says what is allowed. */
bool house_value_set(HouseValues *values, size_t row, double value, Fault *fault);

/* NAME=VALUE for each that is not as at the opening; returns how many. They are the arena's; `settings` has room for
 * all. */
size_t house_value_settings(const HouseValues *values, const char **settings, Arena *arena);
