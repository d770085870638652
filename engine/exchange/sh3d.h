/* Homes of Sweet Home 3D (.sh3d, from 5.3 on): walls, doors, furniture and rooms of one storey. */
#pragma once

#include "exchange/house_builder.h"

bool sh3d_read(HouseBuilder *builder);
