/* Imports Vadere scenarios (.scenario, JSON): obstacles and the frame become walls and furniture, absorbing targets
 * exits, sources crowds, and existing pedestrians walkers. */
#pragma once

#include "exchange/house_builder.h"

bool vadere_read(HouseBuilder *builder);
