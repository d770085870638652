/* Makes a free way quicker (hasten.h), and sweeps the body along it: the descent looks at the stations and at places
 * between them, the sweep at everything. */
#pragma once

#include "route/route.h"
#include "route/way.h"

/* Makes a way quicker that keeps `margin` m. The way and its time, s, stay as they are where the descent leads too near
 * to something. Returns false if interrupted. */
bool quicken_way(const RouteQuery *query, const Rectangle *body, double margin, Way *way, double *time);

/* Makes a copy of a way quicker whose stations lie `spacing` times as far apart, for way_free. The time is infinite
 * where this leads too near to something. Returns false if interrupted. */
bool quicken_copy(const RouteQuery *query, const Rectangle *body, double margin, const Way *from, double spacing,
                  Way *copy, double *time);

/* Leads a way along the middle where that costs no time, unless this comes too near to something. Returns false if
 * interrupted. */
bool quicken_centre(const RouteQuery *query, const Rectangle *body, double margin, Way *way);
