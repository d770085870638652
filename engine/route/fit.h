/* Computes by how much a body fits, with proof: see fit.c. */
#pragma once

#include "route/route.h"
#include "route/search.h"

/* The tightest place of the widest path. There is a path with this margin, unless the search gave up, and none with
 * more than `margin` + FIT_RESOLUTION. */
typedef struct FitPlace {
    Vec2 centre;    /* m, of the body */
    double heading; /* rad, of the body or its opposite */
    double margin;  /* m, -HUGE_VAL: not known */
    int face;       /* the planned face that decides, or -1 */
    bool far;       /* True if that is the nearest one within FREESPACE_FARTHEST */
} FitPlace;

/* Finds the face of a place that is `far` in a free space, which does not note it; another place keeps its own. */
void fit_find_face(const FreeSpace *space, const Rectangle *body, FitPlace *place);

typedef enum FitAnswer {
    FIT_KNOWN,
    FIT_INTERRUPTED, /* the tightest place is not known */
} FitAnswer;

/* Finds the tightest place of the widest path. Its margin is the largest growth, up to `most` m, with which the body
 * passes each goal and leaves by any rigid motion; -HUGE_VAL if that is less than `least`. A deep one takes long. */
__attribute__((warn_unused_result)) FitAnswer fit_margin(const RouteQuery *query, const Rectangle *body,
                                                         const Goal *goals, size_t goal_count, double least,
                                                         double most, FitPlace *tightest);

#define FIT_RESOLUTION 0.003 /* m */
