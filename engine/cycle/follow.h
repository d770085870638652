/* Periodic orbits followed as a parameter changes, stable or not, through folds.
 *
 * An orbit of p cycles solves P^p(x; v) - x = 0. The solutions (x, v) form a curve, which is followed by
 * pseudo-arclength [Keller 1977]: a step along its tangent, then Newton's iteration back to it at right angles to that,
 * with the exact derivative in x (the multipliers come with it) and a central difference in v. Where v turns back the
 * curve goes on.
 *
 * Points are located on the way, between the two steps where their test changes its sign:
 *
 *     fold      dv along the curve is 0: a multiplier is +1, and two orbits meet
 *     flip      a multiplier is -1: an orbit of twice the period begins
 *     pitchfork a multiplier is +1, and the curve does not turn: the orbit loses its mirror symmetry, and two that are
 *               each other's mirror image begin. The curve of such a pair does turn there, from one of them to the
 *               other, where the orbit that is its own image goes on: it is not followed into what is known of it
 *     Neimark   a pair of multipliers is on the unit circle: a torus begins
 *     touching  a turn of the motion reaches a stop or leaves it: the number of contacts of the orbit changes, and the
 *               multipliers may jump; the branch bends, but does not break where the force begins at 0
 *
 * Where an orbit begins to touch, the derivative changes so quickly that no stable step may lead on: then the curve is
 * lost there, and the point is a touching one, too: the end of the branch without contact. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "cycle/cycle.h"

/* A cycle with a parameter. */
typedef struct FollowFamily {
    Cycle (*at)(void *context,
                double value); /* which is valid until the next call; given NULL: the value is impossible */
    void *context;
    double from, to; /* least and greatest value */
    bool rough;      /* the cycles at two values differ by more than rounding besides, as where modes are recomputed */
} FollowFamily;

typedef enum FollowKind {
    FOLLOW_STEP,
    FOLLOW_FOLD,
    FOLLOW_FLIP,
    FOLLOW_PITCHFORK,
    FOLLOW_NEIMARK,
    FOLLOW_TOUCH
} FollowKind;

/* "fold", "flip", ... ; "" for a step */
const char *follow_kind_name(FollowKind kind);

typedef struct FollowPoint {
    FollowKind kind;
    double value;   /* of the parameter */
    double peak;    /* N, largest force; 0: without contact */
    double re, im;  /* of the multiplier of a located point nearest to the circle, or of the largest */
    double largest; /* |multiplier| */
    bool stable;
    size_t switches; /* of the orbit, between contact and none */
    size_t state;    /* of its state: see follow_state */
} FollowPoint;

typedef enum FollowEnd {
    FOLLOW_RANGE, /* the end of the range */
    FOLLOW_LOST,  /* no step, however small, leads on */
    FOLLOW_LONG,  /* FOLLOW_STEPS_MOST steps */
    FOLLOW_IMAGE, /* the pitchfork at which it meets its mirror image, its last point */
    FOLLOW_STOPPED,
} FollowEnd;

enum { FOLLOW_STEPS_MOST = 4000 /* in each direction */ };

typedef struct FollowBranch {
    FollowPoint *points;           /* (count) along the curve */
    size_t count, capacity, start; /* start: index of the orbit that was followed */
    size_t period;
    double *memory; /* of the states, in the order in which they were found */
    size_t states, memory_count, memory_capacity;
    FollowEnd below, above; /* how the curve ended in either direction */
} FollowBranch;

/* Follows an orbit of `period` cycles through `point` (states) at `value`, both ways; `step` is the largest step as a
 * share of the range. An interrupted branch is a part of the whole one, to the bit, and ends with FOLLOW_STOPPED.
 * Returns false if the point lies on none; follow_clear releases the branch. */
bool follow_run(FollowBranch *branch, const FollowFamily *family, double value, const double *point, size_t period,
                double step, const Stop *stop);

/* Follows the orbit that begins at a flip, of twice the period, or at a pitchfork, the point `at` of a branch of the
 * family, whether it is stable or not: along the direction in which motions leave there. From the pitchfork at which a
 * branch ends it is the orbit that is its own mirror image, both ways. Returns false if there is none in reach. */
bool follow_branch_off(FollowBranch *begun, const FollowFamily *family, const FollowBranch *branch, size_t at,
                       double step, const Stop *stop);

/* Returns the state (states) at the cycle's end of a point. */
static inline const double *follow_state(const FollowBranch *branch, size_t point) {
    return branch->memory + branch->points[point].state * branch->states;
}

void follow_clear(FollowBranch *branch);
