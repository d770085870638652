/* Imports DXF drawings (text form): lines on wall layers become walls, arcs on door layers doors, blocks and closed
 * outlines on furniture layers furniture. A wall drawn as two lines stays two walls of zero thickness; a slender
 * rectangle or a broad polyline becomes a wall of that thickness. */
#pragma once

#include "exchange/house_builder.h"

bool dxf_read(HouseBuilder *builder);
