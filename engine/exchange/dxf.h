/* Drawings (DXF, as text): lines on layers of walls become walls, arcs on layers of doors doors, blocks and closed
 * outlines on layers of furniture furniture. A wall drawn as two lines stays two walls of no thickness; one that
 * is drawn as a slender rectangle, or as a broad polyline, is as thick as that. */
#pragma once

#include "exchange/house_builder.h"

bool dxf_read(HouseBuilder *builder);
