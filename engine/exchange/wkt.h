/* Walkable areas as well-known text, as JuPedSim and PedPy have them: POLYGON, MULTIPOLYGON, GEOMETRYCOLLECTION, also
 * several one after another. What lies inside the areas is free; their outer and inner rings become walls of no
 * thickness, and so do single lines. Metres, unless the options say otherwise. */
#pragma once

#include "exchange/house_builder.h"

bool wkt_read(HouseBuilder *builder);
