/* What is done to a plan that importers have built: it is brought near its origin, people who stand inside something
 * are left out, what lacks is noted, and it is checked as a file is. */
#pragma once

#include "exchange/house_builder.h"

/* Hands the plan over, with a note of where it comes from. False: a fault, and the plan is as it was. */
bool house_finish_plan(HouseBuilder *builder, Plan *plan);
