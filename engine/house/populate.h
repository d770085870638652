/* Who stands where when the house begins: the people of the plan, and the members of its crowds, whose places, headings
 * and free speeds are drawn from the house's seed. */
#pragma once

#include "house/house.h"

/* Fills house->people, whose plan, profiles and distances must be there. False: faults say who stands inside whom, or
 * which crowd has no room. */
bool populate_house(House *house, Fault *fault);
