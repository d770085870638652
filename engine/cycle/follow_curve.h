/* Curves of folds, flips and other located points over two parameters: where in the plane an orbit is lost, or loses
 * its stability.
 *
 * A point that was located on a branch (follow.h) is followed as a second parameter changes: at each of its values the
 * orbit is followed in the first one, close to where the point is expected by the last two, and the point is located
 * again. So each point of a curve is as exact as one of a branch. The curve ends where the point is not found in reach
 * however small the step, as at a cusp, where two folds meet; it is not followed round turns in the second parameter.
 */
#pragma once

#include "cycle/follow.h"

/* A family whose second parameter can be set. */
typedef struct FollowPlane {
    FollowFamily *family;                     /* over the first parameter; its range is moved and put back */
    bool (*set)(void *context, double other); /* sets the second parameter of the family; false: impossible */
    void *context;
    double other;       /* value of the second parameter where the branch was followed */
    double least, most; /* range of the second parameter */
    size_t steps;       /* values of a curve over that range: the largest step is their distance */
} FollowPlane;

typedef struct FollowCurve {
    FollowKind kind;
    size_t period;
    double *value, *other; /* (count) the first and the second parameter, by rising second */
    double *off;           /* (count) distance of the multiplier from the unit circle */
    size_t count, capacity;
    bool whole[2]; /* True if the curve reached the least and the most of either range */
} FollowCurve;

/* Follows the point `at` of a branch over the plane. Returns false if it was interrupted; follow_curve_clear releases
 * the curve in either case. */
bool follow_curve_run(FollowCurve *curve, const FollowPlane *plane, const FollowBranch *branch, size_t at,
                      const Stop *stop);

void follow_curve_clear(FollowCurve *curve);
