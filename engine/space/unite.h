/* Unites polygons on a grid, as GEOS does, but quicker where few of them meet. */
#pragma once

#define GEOS_USE_ONLY_R_API
#include <geos_c.h>

/* Unites the polygons of a collection, with all coordinates on a grid of spacing `grid` m. The result is that of
 * GEOSUnaryUnionPrec_r, with its rings in the same order and from the same points, except that rings may begin
 * elsewhere in a heap of polygons that touch in many corners. The caller destroys it. NULL: GEOS failed. */
GEOSGeometry *unite_polygons(GEOSContextHandle_t geos, const GEOSGeometry *collection, double grid);
