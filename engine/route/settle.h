/* Settles how a chair drives: as decide.h says, by a way round what misled the search, or by an answer that is kept
 * from another house. See settle.c. */
#pragma once

#include <stddef.h>

#include "route/decide.h"

/* Finds a way that passes the goals in order, the last of which is across an exit, and writes it to `track`, an empty
 * one, from the start on, without clearances; `pins` (goal_count) are the poses at which the legs of one that was only
 * searched end. Without one `tightest` is the place that decides whether the body fits, up to a lack of `depth` m
 * (fit.h). */
DecideAnswer settle_way(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                        double depth, SearchTrack *track, size_t *pins, FitPlace *tightest);

/* Settles by the coarse grains alone: where it finds a way, settle_way finds one as well, though perhaps another. */
DecideAnswer settle_quickly(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                            SearchTrack *track);
