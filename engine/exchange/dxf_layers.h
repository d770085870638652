/* What the layers of a drawing are for: as the options say, or by their names. Only for the files of dxf.c. */
#pragma once

#include "exchange/dxf_file.h"

typedef enum DxfRole {
    DXF_UNKNOWN,
    DXF_WALLS,
    DXF_DOORS,
    DXF_FURNITURE,
    DXF_EXITS,
    DXF_NOTHING, /* dimensions, texts and the like */
    DXF_ROLES,
} DxfRole;

/* Gives each layer its role, and notes the choice; a block has one, too, when it is called like a door or furniture.
 * Where no layer is called like walls, all are walls that are called like nothing else. False: a fault about the
 * options. */
bool dxf_layers_choose(DxfFile *file, HouseBuilder *builder);
