/* What the fuzz targets of the importers share. */
#pragma once

#include "exchange/house_builder.h"

/* Reads the file with an importer. What it takes is a plan that survives writing; of a small one the walkable area is
 * made, too. */
void fuzz_import(const char *path, bool (*read)(HouseBuilder *builder));
