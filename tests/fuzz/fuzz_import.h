/* The common part of the importers' fuzz targets. */
#pragma once

#include "exchange/house_builder.h"

/* Imports the file. A resulting plan must survive writing; for a small plan the walkable area is computed, too. */
void fuzz_import(const char *path, bool (*read)(HouseBuilder *builder));
