/* Imports DXF drawings (text form): lines on wall layers become walls, arcs on door layers doors, blocks and closed
 * outlines on furniture layers furniture. Walls drawn as two lines (wall_faces.h), slender
 * rectangles and broad polylines become walls with a thickness. */
#pragma once

#include "exchange/house_builder.h"

bool dxf_read(HouseBuilder *builder);
