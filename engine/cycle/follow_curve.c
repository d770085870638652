#include "cycle/follow_curve.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"

static const double REACH = 0.02;   /* of the first parameter's range, to either side of where the point is expected */
static const double STEP = 0.1;     /* of that reach, the largest step along the branch */
static const double FOOTHOLD = 0.3; /* of the reach: how far from the point the orbit is taken from which to go on */
static const double TRUSTED = 0.25; /* of the reach, from where a point is expected: farther ones are other points */
static const double SMALLEST = 1.0 / 64; /* of the largest step */

/* Where a curve is: its point, and an orbit of the branch near it. */
typedef struct Stand {
    double value, other;
    double from;   /* value of the orbit */
    double *state; /* (states) */
} Stand;

static void add(FollowCurve *curve, double value, double other, double off) {
    size_t capacity = curve->capacity;
    curve->value = memory_reserve(curve->value, &capacity, curve->count + 1, sizeof *curve->value);
    capacity = curve->capacity;
    curve->other = memory_reserve(curve->other, &capacity, curve->count + 1, sizeof *curve->other);
    capacity = curve->capacity;
    curve->off = memory_reserve(curve->off, &capacity, curve->count + 1, sizeof *curve->off);
    curve->capacity = capacity;
    curve->value[curve->count] = value;
    curve->other[curve->count] = other;
    curve->off[curve->count++] = off;
}

/* Returns the point of the kind that is nearest to a value, or SIZE_MAX. */
static size_t nearest(const FollowBranch *branch, FollowKind kind, double value) {
    size_t found = (size_t)-1;
    for (size_t i = 0; i < branch->count; i++)
        if (branch->points[i].kind == kind &&
            (found == (size_t)-1 || fabs(branch->points[i].value - value) < fabs(branch->points[found].value - value)))
            found = i;
    return found;
}

/* Takes the orbit of a branch that is about `away` from its point `at`, on the side that is stable, if any. */
static void take_stand(Stand *stand, const FollowBranch *branch, size_t at, double away) {
    double best = HUGE_VAL, value = branch->points[at].value;
    for (size_t i = 0; i < branch->count; i++) {
        const FollowPoint *point = &branch->points[i];
        double off = fabs(fabs(point->value - value) - away) + (point->stable ? 0 : away);
        if (point->kind != FOLLOW_STEP || off >= best)
            continue;
        best = off;
        stand->from = point->value;
        memcpy(stand->state, follow_state(branch, i), branch->states * sizeof *stand->state);
    }
    stand->value = value;
}

/* Locates the point where the second parameter is `other`, from a stand; moves the stand there. */
static bool locate_at(const FollowPlane *plane, FollowCurve *curve, Stand *stand, double expected, double other,
                      double reach, const Stop *stop) {
    FollowFamily *family = plane->family;
    const double from = family->from, to = family->to;
    FollowBranch branch;
    if (!plane->set(plane->context, other))
        return false;
    double middle = expected, start = stand->from + (expected - stand->value);
    family->from = fmax(from, fmin(middle, start) - reach);
    family->to = fmin(to, fmax(middle, start) + reach);
    bool good = start > family->from && start < family->to &&
                follow_run(&branch, family, start, stand->state, curve->period, STEP, stop);
    if (good) {
        size_t at = nearest(&branch, curve->kind, expected);
        good = at != (size_t)-1 && !stop_requested(stop) && fabs(branch.points[at].value - expected) < TRUSTED * reach;
        if (good) {
            take_stand(stand, &branch, at, FOOTHOLD * reach);
            stand->other = other;
            const FollowPoint *point = &branch.points[at];
            add(curve, point->value, other, fabs(real_hypot(point->re, point->im) - 1));
        }
        follow_clear(&branch);
    }
    family->from = from;
    family->to = to;
    return good;
}

/* Goes from the first point of the curve towards one end of the second parameter. */
static bool go(const FollowPlane *plane, FollowCurve *curve, const Stand *first, size_t states, double end,
               const Stop *stop) {
    double longest = (plane->most - plane->least) / (double)(plane->steps > 1 ? plane->steps - 1 : 1);
    double step = longest, slope = 0, reach = REACH * (plane->family->to - plane->family->from);
    Stand stand = *first;
    stand.state = memory_zeroed(states, sizeof *stand.state);
    memcpy(stand.state, first->state, states * sizeof *stand.state);
    while (stand.other != end && step >= SMALLEST * longest && !stop_requested(stop)) {
        double left = fabs(end - stand.other), by = fmin(step, left) * (end > stand.other ? 1 : -1);
        double other = step >= left ? end : stand.other + by, value = stand.value, before = stand.other;
        if (locate_at(plane, curve, &stand, value + slope * (other - before), other, reach, stop)) {
            slope = (stand.value - value) / (other - before);
            step = fmin(longest, 1.5 * step);
        } else {
            step /= 2;
        }
        bool inside = stand.value > plane->family->from && stand.value < plane->family->to;
        if (!inside)
            break;
    }
    bool whole = stand.other == end;
    memory_free(stand.state);
    return whole;
}

/* Turns the points from `first` on round. */
static void reverse(FollowCurve *curve) {
    double *const columns[] = {curve->value, curve->other, curve->off};
    for (size_t c = 0; c < 3; c++)
        for (size_t i = 0, j = curve->count; i + 1 < j; i++, j--) {
            double moved = columns[c][i];
            columns[c][i] = columns[c][j - 1];
            columns[c][j - 1] = moved;
        }
}

bool follow_curve_run(FollowCurve *curve, const FollowPlane *plane, const FollowBranch *branch, size_t at,
                      const Stop *stop) {
    const FollowPoint *point = &branch->points[at];
    *curve = (FollowCurve){.kind = point->kind, .period = branch->period};
    Stand stand = {.state = memory_zeroed(branch->states, sizeof *stand.state), .other = plane->other};
    take_stand(&stand, branch, at, FOOTHOLD * REACH * (plane->family->to - plane->family->from));
    curve->whole[0] = go(plane, curve, &stand, branch->states, plane->least, stop);
    reverse(curve);
    add(curve, point->value, plane->other, fabs(real_hypot(point->re, point->im) - 1));
    curve->whole[1] = go(plane, curve, &stand, branch->states, plane->most, stop);
    memory_free(stand.state);
    plane->set(plane->context, plane->other);
    return !stop_requested(stop);
}

void follow_curve_clear(FollowCurve *curve) {
    memory_free(curve->value);
    memory_free(curve->other);
    memory_free(curve->off);
    *curve = (FollowCurve){0};
}
