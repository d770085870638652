/* Finds the unit of a drawing. The files often say nothing or the wrong unit, so the evidence is asked in this order:
 *
 * 1. the option,
 * 2. dimensions: a text 16'-0" beside a measured 192 says inches,
 * 3. the file's header, unless the plan's size, its doors or its walls would be impossible,
 * 4. the only unit among mm, cm, m, inch and ft in which doors, walls and the plan have possible sizes.
 *
 * What remains doubtful is an error, which names the units and the sizes. Private to the DXF importer. */
#pragma once

#include "exchange/dxf_shapes.h"

/* Stores the metres in a unit of the drawing and notes what decided. Returns false after an error. */
bool dxf_unit_choose(const DxfFile *file, const DxfShapes *shapes, HouseBuilder *builder, double *metres);
