/* Decides how a chair drives: the quickest of the ways that are found and proved free. See decide.c. Only
 * settle.c asks for them. */
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

/* Finds a way that passes the goals in order, as settle_way does; `coarsely`: by the coarse grains alone. */
DecideAnswer decide_directly(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                             bool coarsely, double depth, SearchTrack *track, size_t *pins, FitPlace *tightest);

/* Returns the radius of a disc about the axle that never leaves a body, m: the same for all bodies that are searched
 * for, so that they share a field. */
double decide_radius(const Rectangle *body);

/* Searches a way on which the drive wheels may skid sideways, in turns about the body's middle, and writes it to
 * `track`, an empty one, with the length of the skids: proved free, but neither smooth nor known to be the least. */
SearchAnswer decide_with_skids(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                               SearchTrack *track);
