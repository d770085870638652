/* Decides how a chair drives: the quickest of the ways that are found and proved free. See decide.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "route/fit.h"
#include "route/route.h"
#include "route/search.h"

typedef enum DecideAnswer {
    DECIDE_FOUND,
    DECIDE_SEARCHED,   /* a way was found by search alone, so that it hardly has room */
    DECIDE_NONE,       /* no way was found, which proves nothing: the body fits, or whether it does is not decided */
    DECIDE_TOO_NARROW, /* the body does not fit, which is proved */
    DECIDE_INTERRUPTED,
} DecideAnswer;

/* Finds a way that passes the goals in order, the last of which is across an exit, and writes it to `track`, an empty
 * one, from the start on, without clearances; `pins` (goal_count) are the poses at which the legs of one that was only
 * searched end. Without one `tightest` is the place that decides whether the body fits,
 * up to a lack of `depth` m (fit.h). */
DecideAnswer decide_way(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                        double depth, SearchTrack *track, size_t *pins, FitPlace *tightest);

/* Decides by the coarse grains alone: where it finds a way, decide_way finds one as well, though perhaps another. */
DecideAnswer decide_quickly(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                            SearchTrack *track);

/* Searches a way on which the drive wheels may skid sideways, in turns about the body's middle, and writes it to
 * `track`, an empty one, with the length of the skids: proved free, but neither smooth nor known to be the least. */
SearchAnswer decide_with_skids(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                               SearchTrack *track);
