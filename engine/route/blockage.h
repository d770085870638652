/* Says where and by how much a body sticks: see blockage.c. */
#pragma once

#include "route/fit.h"
#include "route/route.h"
#include "route/search.h"

/* The place where the body starts in something. */
void blockage_of_start(Blockage *blockage, const RouteQuery *query, const Rectangle *body);

/* The tightest place of a body that does not fit (margin negative), or only just. */
void blockage_of_fit(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const FitPlace *place);

/* The place of a track, searched for a smaller body, where the true one is deepest in something. */
void blockage_of_track(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const SearchTrack *track);
