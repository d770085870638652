/* Scenarios of Vadere (.scenario, JSON): obstacles and the frame round the plan become walls and furniture, targets
 * that take people in become exits, sources crowds, pedestrians that are there already people on foot. */
#pragma once

#include "exchange/house_builder.h"

bool vadere_read(HouseBuilder *builder);
