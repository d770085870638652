/* Imports walkable areas in well-known text, as JuPedSim and PedPy write them: POLYGON, MULTIPOLYGON and
 * GEOMETRYCOLLECTION, one or several. The inside of the areas is free; their outer and inner rings and single lines
 * become walls of zero thickness. Lengths are in metres unless the options name a unit. */
#pragma once

#include "exchange/house_builder.h"

bool wkt_read(HouseBuilder *builder);
