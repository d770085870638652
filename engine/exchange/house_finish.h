/* Completes a plan that an importer has built: moves it near its origin, leaves out people inside obstacles, notes
 * gaps, and checks it as a house file is checked. */
#pragma once

#include "exchange/house_builder.h"

/* Hands over the plan with a note about its origin. Returns false after an error and leaves `plan` unchanged. */
bool house_finish_plan(HouseBuilder *builder, Plan *plan);
