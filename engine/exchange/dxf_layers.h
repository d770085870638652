/* Assigns roles to the layers of a drawing, from the options or from their names. Private to the DXF importer. */
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

/* Gives each layer a role and notes the choice; a block named like a door or furniture gets one, too. If no layer is
 * named like walls, all layers without a recognised name are walls. Returns false after an error in the options. */
bool dxf_layers_choose(DxfFile *file, HouseBuilder *builder);
