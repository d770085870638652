/* Finds where a body sticks, and how much width is missing: see blockage.c. */
#pragma once

#include "route/fit.h"
#include "route/route.h"
#include "route/search.h"

/* Fills in the place where the body overlaps something at the start. */
void blockage_of_start(Blockage *blockage, const RouteQuery *query, const Rectangle *body);

/* Fills in the tightest place of a body that lacks a margin there, or only just fits. */
void blockage_of_fit(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const FitPlace *place);

/* Fills in the neck of a disc's way, which may be as wide as the disc or wider: the search resolves no more. That the
 * disc needs its own width is an estimate. Returns false, with the blockage unchanged, after an interruption. */
bool blockage_of_disc(Blockage *blockage, const RouteQuery *query, double radius, const Goal *goals, size_t goal_count);

/* Fills in the place of a track, searched for a smaller body, where the true body overlaps something most deeply. */
void blockage_of_track(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const SearchTrack *track);
