/* Computes by how much a body fits: see fit.c. */
#pragma once

#include "route/route.h"
#include "route/search.h"

/* The tightest place of the widest path. */
typedef struct FitPlace {
    Vec2 centre;    /* m, of the body */
    double heading; /* rad */
    double margin;  /* m */
    int face;       /* the planned face that decides, or -1 */
} FitPlace;

typedef enum FitAnswer {
    FIT_KNOWN,
    FIT_INTERRUPTED, /* the tightest place is not known */
} FitAnswer;

/* Finds the tightest place of the widest path. Its margin is the largest growth, up to FIT_MOST, with which the body
 * passes the goals in order by any rigid motion. */
__attribute__((warn_unused_result)) FitAnswer fit_margin(const RouteQuery *query, const Rectangle *body,
                                                         const Goal *goals, size_t goal_count, FitPlace *tightest);

#define FIT_MOST 0.1 /* m */

/* The lattice of fit_margin ends at 3.1 mm, so the margin is low by half of that. */
#define FIT_BIAS 0.0015 /* m */
