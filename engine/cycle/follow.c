#include "cycle/follow.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"
#include "cycle/orbit.h"

static const double CONVERGED = 1e-10; /* of the state's length */
static const double SMALLEST = 1e-7;   /* share of the largest step: a smaller one is given up */
static const double DIFFERENCE = 1e-6; /* of the range, for the derivative by the parameter */
static const double BEYOND = 1e-4;     /* of the largest step, at which a lost curve is looked beyond */
static const double LOCATED = 1e-6;    /* of a multiplier, from the circle */
static const double ON_CIRCLE = 1e-9;  /* of a located point's test */
enum { CORRECTIONS = 8, QUICK = 3 /* corrections, below which the next step is longer */, HALVINGS = 60 };

const char *follow_kind_name(FollowKind kind) {
    static const char *const names[] = {"", "fold", "flip", "Neimark-Sacker", "touching"};
    return names[kind];
}

/* A point of the curve: state by its scale and value by the range, and what is known there. */
typedef struct Place {
    double *at, *tangent; /* (states + 1) */
    double *re, *im;      /* (states) multipliers */
    double largest, peak;
    size_t outside; /* multipliers beyond the circle */
} Place;

typedef struct Walk {
    const FollowFamily *family;
    const Stop *stop;
    size_t states, period;
    double scale; /* length of a state */
    double *memory, *derivative, *gap, *system, *column;
    lapack_int *pivots;
} Walk;

static double value_of(const Walk *walk, const double *at) {
    return walk->family->from + at[walk->states] * (walk->family->to - walk->family->from);
}

/* Computes the gap P^p(x; v) - x, in units of the scale, and unless NULL the derivative of P^p. */
static bool find_gap(const Walk *walk, const double *at, double shift, double *gap, double *derivative) {
    Cycle cycle = walk->family->at(walk->family->context, value_of(walk, at) + shift);
    if (!cycle.given)
        return false;
    for (size_t i = 0; i < walk->states; i++)
        gap[i] = at[i] * walk->scale;
    if (orbit_map(cycle, gap, walk->period, derivative, walk->stop) != ORBIT_GOOD)
        return false;
    for (size_t i = 0; i < walk->states; i++)
        gap[i] = gap[i] / walk->scale - at[i];
    return true;
}

/* Fills the bordered system, (states + 1) x (states + 1): the derivative of the gap, and the row `border` below. */
static bool make_system(Walk *walk, const double *at, const double *border) {
    size_t n = walk->states, size = n + 1;
    double by = DIFFERENCE * (walk->family->to - walk->family->from);
    double *up = walk->column, *down = walk->column + n;
    if (!find_gap(walk, at, by, up, NULL) || !find_gap(walk, at, -by, down, NULL) ||
        !find_gap(walk, at, 0, walk->gap, walk->derivative))
        return false;
    for (size_t c = 0; c < n; c++) {
        for (size_t r = 0; r < n; r++)
            walk->system[c * size + r] = walk->derivative[c * n + r] - (r == c);
        walk->system[c * size + n] = border[c];
    }
    for (size_t r = 0; r < n; r++)
        walk->system[n * size + r] = (up[r] - down[r]) / (2 * DIFFERENCE);
    walk->system[n * size + n] = border[n];
    return true;
}

static bool solve(Walk *walk, double *right) {
    lapack_int size = (lapack_int)walk->states + 1;
    return LAPACKE_dgesv(LAPACK_COL_MAJOR, size, 1, walk->system, size, walk->pivots, right, size) == 0;
}

static double dot(const double *a, const double *b, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Finds multipliers and largest force at a solution, whose derivative is at hand. */
static bool describe(Walk *walk, Place *place) {
    lapack_int n = (lapack_int)walk->states;
    if (LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', n, walk->derivative, n, place->re, place->im, NULL, 1, NULL, 1) != 0)
        return false;
    place->largest = 0;
    place->outside = 0;
    for (size_t i = 0; i < walk->states; i++) {
        double size = real_hypot(place->re[i], place->im[i]);
        place->largest = fmax(place->largest, size);
        place->outside += size > 1;
    }
    Cycle cycle = walk->family->at(walk->family->context, value_of(walk, place->at));
    CycleMotion motion = cycle_create(cycle, 0);
    for (size_t i = 0; i < walk->states; i++)
        walk->gap[i] = place->at[i] * walk->scale;
    cycle.kind->set_state(motion.own, walk->gap);
    double *peak = cycle.kind->peaks(motion.own);
    peak[0] = peak[1] = 0;
    for (size_t i = 0; i < walk->period; i++)
        cycle_run(&motion);
    place->peak = fmax(peak[0], peak[1]);
    cycle_destroy(&motion);
    return true;
}

static double *place_room(size_t states) {
    return memory_zeroed(4 * states + 2, sizeof(double));
}

static Place place_of(double *room, size_t states) {
    return (Place){.at = room, .tangent = room + states + 1, .re = room + 2 * states + 2, .im = room + 3 * states + 2};
}

static void copy_place(Place *to, const Place *from, size_t states) {
    Place own = *to;
    memcpy(own.at, from->at, (4 * states + 2) * sizeof *own.at);
    *to = *from;
    to->at = own.at;
    to->tangent = own.tangent;
    to->re = own.re;
    to->im = own.im;
}

/* Goes `length` along the tangent and back to the curve. Returns the number of corrections, 0: it did not come back. */
static int step_to(Walk *walk, const Place *from, double length, Place *to) {
    size_t size = walk->states + 1;
    double *right = walk->column + 2 * walk->states;
    for (size_t i = 0; i < size; i++)
        to->at[i] = from->at[i] + length * from->tangent[i];
    for (int k = 1; k <= CORRECTIONS; k++) {
        if (stop_requested(walk->stop) || !make_system(walk, to->at, from->tangent))
            return 0;
        bool there = sqrt(dot(walk->gap, walk->gap, walk->states)) < CONVERGED;
        for (size_t i = 0; i < size; i++)
            right[i] = there ? i == walk->states : i < walk->states ? -walk->gap[i] : 0;
        if (!solve(walk, right))
            return 0;
        if (there) {
            double norm = sqrt(dot(right, right, size));
            for (size_t i = 0; i < size; i++)
                to->tangent[i] = right[i] / norm;
            return describe(walk, to) ? k : 0;
        }
        for (size_t i = 0; i < size; i++)
            to->at[i] += right[i];
    }
    return 0;
}

/* Events ------------------------------------------------------------------------------------------------------------
 */

static size_t count_flipped(const Place *place, size_t states) {
    size_t count = 0;
    for (size_t i = 0; i < states; i++)
        count += place->im[i] == 0 && place->re[i] < -1;
    return count;
}

static size_t count_pairs(const Place *place, size_t states) {
    size_t count = 0;
    for (size_t i = 0; i < states; i++)
        count += place->im[i] > 0 && real_hypot(place->re[i], place->im[i]) > 1;
    return count;
}

/* True if the event lies between two places. */
static bool is_between(FollowKind kind, const Place *a, const Place *b, size_t states) {
    switch (kind) {
    case FOLLOW_FOLD:
        return (a->tangent[states] > 0) != (b->tangent[states] > 0);
    case FOLLOW_FLIP:
        return count_flipped(a, states) % 2 != count_flipped(b, states) % 2;
    case FOLLOW_NEIMARK: /* a pair may also split into two real ones, outside the circle */
        return count_pairs(a, states) != count_pairs(b, states) &&
               (a->outside == b->outside + 2 || b->outside == a->outside + 2);
    case FOLLOW_TOUCH:
        return (a->peak > 0) != (b->peak > 0);
    case FOLLOW_STEP:
        break;
    }
    return false;
}

/* Returns the multiplier that is nearest to where it leaves the circle. */
static size_t leaving(FollowKind kind, const Place *place, size_t states) {
    size_t which = 0;
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < states; i++) {
        bool pair = place->im[i] > 0;
        double away = kind == FOLLOW_FOLD   ? real_hypot(place->re[i] - 1, place->im[i])
                      : kind == FOLLOW_FLIP ? real_hypot(place->re[i] + 1, place->im[i])
                                            : fabs(real_hypot(place->re[i], place->im[i]) - 1) + !pair;
        if (kind == FOLLOW_STEP || kind == FOLLOW_TOUCH)
            away = -real_hypot(place->re[i], place->im[i]);
        if (away < nearest) {
            nearest = away;
            which = i;
        }
    }
    return which;
}

static void add_point(FollowBranch *branch, const Walk *walk, FollowKind kind, const Place *place) {
    size_t which = leaving(kind, place, walk->states);
    branch->points = memory_reserve(branch->points, &branch->capacity, branch->count + 1, sizeof *branch->points);
    branch->points[branch->count++] = (FollowPoint){.kind = kind,
                                                    .value = value_of(walk, place->at),
                                                    .peak = place->peak,
                                                    .re = place->re[which],
                                                    .im = place->im[which],
                                                    .largest = place->largest,
                                                    .stable = place->largest < 1};
}

/* Locates an event between `from` and the place `length` further on by halving. */
static bool locate(Walk *walk, FollowKind kind, const Place *from, double length, Place *at) {
    double low = 0, high = length;
    for (int i = 0; i < HALVINGS && high - low > ON_CIRCLE * length; i++) {
        double middle = low + (high - low) / 2;
        if (!step_to(walk, from, middle, at))
            return false;
        if (is_between(kind, from, at, walk->states))
            high = middle;
        else
            low = middle;
    }
    if (!step_to(walk, from, high, at))
        return false;
    size_t which = leaving(kind, at, walk->states); /* multipliers that only meet outside the circle are no event */
    return kind == FOLLOW_TOUCH || fabs(real_hypot(at->re[which], at->im[which]) - 1) < LOCATED;
}

/* True if just beyond a place, along the curve, a motion without contact touches, or the reverse. */
static bool touches_beyond(Walk *walk, const Place *here, double length) {
    size_t n = walk->states;
    double at = here->at[n] + length * here->tangent[n];
    Cycle cycle =
        walk->family->at(walk->family->context, walk->family->from + at * (walk->family->to - walk->family->from));
    if (!cycle.given)
        return false;
    CycleMotion motion = cycle_create(cycle, 0);
    for (size_t i = 0; i < n; i++)
        walk->gap[i] = (here->at[i] + length * here->tangent[i]) * walk->scale;
    cycle.kind->set_state(motion.own, walk->gap);
    double *peak = cycle.kind->peaks(motion.own);
    peak[0] = peak[1] = 0;
    for (size_t i = 0; i < walk->period; i++)
        cycle_run(&motion);
    bool touches = fmax(peak[0], peak[1]) > 0;
    cycle_destroy(&motion);
    return touches != (here->peak > 0);
}

/* Walking -----------------------------------------------------------------------------------------------------------
 */

static FollowEnd walk_on(Walk *walk, FollowBranch *branch, const Place *start, double longest) {
    size_t n = walk->states;
    double *rooms[] = {place_room(n), place_room(n), place_room(n)}, step = longest / 4;
    Place here = place_of(rooms[0], n), next = place_of(rooms[1], n), between = place_of(rooms[2], n);
    copy_place(&here, start, n);
    FollowEnd end = FOLLOW_LONG;
    for (size_t steps = 0; steps < FOLLOW_STEPS_MOST; steps++) {
        int corrections = step_to(walk, &here, step, &next);
        if (stop_requested(walk->stop)) {
            end = FOLLOW_STOPPED;
            break;
        }
        if (!corrections || dot(here.tangent, next.tangent, n + 1) < 0.9) {
            step /= 2;
            if (step >= SMALLEST * longest)
                continue;
            end = FOLLOW_LOST;
            if (touches_beyond(walk, &here, BEYOND * longest))
                add_point(branch, walk, FOLLOW_TOUCH, &here);
            break;
        }
        static const FollowKind kinds[] = {FOLLOW_FOLD, FOLLOW_FLIP, FOLLOW_NEIMARK, FOLLOW_TOUCH};
        for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
            if (is_between(kinds[k], &here, &next, n) && locate(walk, kinds[k], &here, step, &between))
                add_point(branch, walk, kinds[k], &between);
        add_point(branch, walk, FOLLOW_STEP, &next);
        copy_place(&here, &next, n);
        if (here.at[n] < 0 || here.at[n] > 1) {
            end = FOLLOW_RANGE;
            break;
        }
        if (corrections <= QUICK)
            step = fmin(longest, 1.5 * step);
    }
    for (size_t i = 0; i < 3; i++)
        memory_free(rooms[i]);
    return end;
}

/* Turns the points that were added last first round. */
static void reverse(FollowBranch *branch) {
    for (size_t i = 0, j = branch->count; i + 1 < j; i++, j--) {
        FollowPoint point = branch->points[i];
        branch->points[i] = branch->points[j - 1];
        branch->points[j - 1] = point;
    }
}

bool follow_run(FollowBranch *branch, const FollowFamily *family, double value, const double *point, size_t period,
                double step, const Stop *stop) {
    Cycle cycle = family->at(family->context, value);
    *branch = (FollowBranch){.period = period};
    if (!cycle.given)
        return false;
    size_t n = cycle_states(cycle), size = n + 1;
    Walk walk = {.family = family, .stop = stop, .states = n, .period = period};
    walk.scale = fmax(sqrt(dot(point, point, n)), cycle_rest_state(cycle));
    walk.memory = memory_zeroed(n * n + n + size * size + 4 * size, sizeof *walk.memory);
    walk.derivative = walk.memory;
    walk.gap = walk.derivative + n * n;
    walk.system = walk.gap + n;
    walk.column = walk.system + size * size;
    walk.pivots = memory_zeroed(size, sizeof *walk.pivots);
    double *room = place_room(n), *other = place_room(n);
    Place start = place_of(room, n), up = place_of(other, n);
    for (size_t i = 0; i < n; i++)
        start.at[i] = point[i] / walk.scale;
    start.at[n] = (value - family->from) / (family->to - family->from);
    start.tangent[n] = 1;
    bool good = step_to(&walk, &start, 0, &up) > 0;
    if (good) {
        for (size_t i = 0; i < size; i++)
            up.tangent[i] = -up.tangent[i];
        branch->below = walk_on(&walk, branch, &up, step);
        reverse(branch);
        branch->start = branch->count;
        add_point(branch, &walk, FOLLOW_STEP, &up);
        for (size_t i = 0; i < size; i++)
            up.tangent[i] = -up.tangent[i];
        branch->above = walk_on(&walk, branch, &up, step);
    }
    memory_free(room);
    memory_free(other);
    memory_free(walk.pivots);
    memory_free(walk.memory);
    return good;
}

void follow_clear(FollowBranch *branch) {
    memory_free(branch->points);
    *branch = (FollowBranch){0};
}
