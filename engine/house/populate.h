/* Places the people when the house begins: the people of the plan, and the members of its crowds, whose positions,
 * headings and free speeds are drawn from the house's seed. */
#pragma once

#include "house/house.h"

/* Fills in house->people; plan, profiles and distances must be ready. Returns false after an error: two people overlap,
 * or a crowd has no room. */
bool populate_house(House *house, Fault *fault);
