/* Drawings (DXF, as text): lines on layers of walls become walls, arcs on layers of doors doors, blocks and closed
 * outlines on layers of furniture furniture. A wall drawn as two lines stays two walls of no thickness; a polyline that
 * is drawn broad is as thick as that. */
#pragma once

#include "exchange/house_builder.h"

bool dxf_read(HouseBuilder *builder);
