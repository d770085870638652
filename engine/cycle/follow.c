#include "cycle/follow.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"
#include "cycle/orbit.h"

static const double CONVERGED = 1e-10, CONVERGED_ROUGHLY = 1e-8; /* of the state's length */
static const double SMALLEST = 1e-7; /* share of the largest step: a smaller one is given up */
static const double DIFFERENCE = 1e-6, DIFFERENCE_ROUGH = 1e-3; /* of the range, for the derivative by the parameter */
static const double BEYOND = 1e-4;    /* of the largest step, at which a lost curve is looked beyond */
static const double LOCATED = 1e-6;   /* of a multiplier, from the circle */
static const double ON_CIRCLE = 1e-9; /* of a located point's test */
static const double PART =
    0.47; /* of a chord: not its middle, which may be the point itself, where no system is regular */
enum { CORRECTIONS = 8, QUICK = 3 /* corrections, below which the next step is longer */, HALVINGS = 60 };

const char *follow_kind_name(FollowKind kind) {
    static const char *const names[] = {"", "fold", "flip", "pitchfork", "Neimark-Sacker", "touching"};
    return names[kind];
}

/* A point of the curve: state by its scale and value by the range, and what is known there. */
typedef struct Place {
    double *at, *tangent; /* (states + 1) */
    double *re, *im;      /* (states) multipliers */
    double largest, peak;
    size_t outside;  /* multipliers beyond the circle */
    size_t switches; /* of the whole orbit */
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
    double share = walk->family->rough ? DIFFERENCE_ROUGH : DIFFERENCE;
    double by = share * (walk->family->to - walk->family->from);
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
        walk->system[n * size + r] = (up[r] - down[r]) / (2 * share);
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
    CycleMotion motion = cycle_create(cycle, 0, walk->stop);
    for (size_t i = 0; i < walk->states; i++)
        walk->gap[i] = place->at[i] * walk->scale;
    cycle.kind->set_state(motion.own, walk->gap);
    double *peak = cycle.kind->peaks(motion.own);
    peak[0] = peak[1] = 0;
    size_t before = cycle.kind->tally(motion.own).switches;
    for (size_t i = 0; i < walk->period; i++)
        cycle_run(&motion);
    place->switches = cycle.kind->tally(motion.own).switches - before;
    place->peak = fmax(peak[0], peak[1]);
    bool whole = cycle_status(&motion) != CYCLE_INTERRUPTED;
    cycle_destroy(&motion);
    return whole;
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

/* Goes from the place `to`, whose tangent is not known yet, to the curve, at right angles to `border`. Returns the
 * number of corrections, 0: it did not come to it. */
static int correct(Walk *walk, const double *border, Place *to) {
    size_t size = walk->states + 1;
    double *right = walk->column + 2 * walk->states;
    for (int k = 1; k <= CORRECTIONS; k++) {
        if (stop_requested(walk->stop) || !make_system(walk, to->at, border))
            return 0;
        bool there =
            sqrt(dot(walk->gap, walk->gap, walk->states)) < (walk->family->rough ? CONVERGED_ROUGHLY : CONVERGED);
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

/* Goes `length` along the tangent and back to the curve; returns as correct does. */
static int step_to(Walk *walk, const Place *from, double length, Place *to) {
    for (size_t i = 0; i <= walk->states; i++)
        to->at[i] = from->at[i] + length * from->tangent[i];
    return correct(walk, from->tangent, to);
}

/* Events ------------------------------------------------------------------------------------------------------------
 */

static size_t count_flipped(const Place *place, size_t states) {
    size_t count = 0;
    for (size_t i = 0; i < states; i++)
        count += place->im[i] == 0 && place->re[i] < -1;
    return count;
}

static size_t count_above(const Place *place, size_t states) {
    size_t count = 0;
    for (size_t i = 0; i < states; i++)
        count += place->im[i] == 0 && place->re[i] > 1;
    return count;
}

static size_t count_pairs(const Place *place, size_t states) {
    size_t count = 0;
    for (size_t i = 0; i < states; i++)
        count += place->im[i] > 0 && real_hypot(place->re[i], place->im[i]) > 1;
    return count;
}

/* True if the event lies between two places. At a pitchfork the tangent may be that of either curve: that the curve
 * does not turn is asked of places farther away. */
static bool is_between(FollowKind kind, const Place *a, const Place *b, size_t states) {
    switch (kind) {
    case FOLLOW_FOLD:
        return (a->tangent[states] > 0) != (b->tangent[states] > 0);
    case FOLLOW_FLIP:
        return count_flipped(a, states) % 2 != count_flipped(b, states) % 2;
    case FOLLOW_PITCHFORK: /* the meeting of two real multipliers outside the circle is none */
        return count_above(a, states) % 2 != count_above(b, states) % 2;
    case FOLLOW_NEIMARK: /* a pair may also split into two real ones, outside the circle */
        return count_pairs(a, states) != count_pairs(b, states) &&
               (a->outside == b->outside + 2 || b->outside == a->outside + 2);
    case FOLLOW_TOUCH:
        return a->switches != b->switches;
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
        bool pair = place->im[i] > 0, one = kind == FOLLOW_FOLD || kind == FOLLOW_PITCHFORK;
        double away = one                   ? real_hypot(place->re[i] - 1, place->im[i])
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
    branch->memory = memory_reserve(branch->memory, &branch->memory_capacity, (branch->memory_count + 1) * walk->states,
                                    sizeof *branch->memory);
    for (size_t i = 0; i < walk->states; i++)
        branch->memory[branch->memory_count * walk->states + i] = place->at[i] * walk->scale;
    branch->points[branch->count++] = (FollowPoint){.kind = kind,
                                                    .value = value_of(walk, place->at),
                                                    .peak = place->peak,
                                                    .re = place->re[which],
                                                    .im = place->im[which],
                                                    .largest = place->largest,
                                                    .stable = place->largest < 1,
                                                    .switches = place->switches,
                                                    .state = branch->memory_count++};
}

/* Locates an event between two places by halving, from a place on the chord each time: where two curves cross, it
 * keeps to the one that both are on. Returns false if there is none; once interrupted, its answer is void. */
static bool locate(Walk *walk, FollowKind kind, const Place *from, const Place *to, Place *at) {
    size_t n = walk->states;
    double *rooms[] = {place_room(n), place_room(n)};
    Place low = place_of(rooms[0], n), high = place_of(rooms[1], n);
    copy_place(&low, from, n);
    copy_place(&high, to, n);
    bool good = true;
    for (int i = 0; i < HALVINGS && good; i++) {
        for (size_t k = 0; k <= n; k++)
            at->at[k] = low.at[k] + PART * (high.at[k] - low.at[k]);
        good = correct(walk, from->tangent, at) > 0;
        if (good)
            copy_place(is_between(kind, &low, at, n) ? &high : &low, at, n);
        if (fabs(high.at[n] - low.at[n]) < ON_CIRCLE * fabs(to->at[n] - from->at[n]) && i > HALVINGS / 2)
            break;
    }
    copy_place(at, &high, n);
    for (size_t i = 0; i < 2; i++)
        memory_free(rooms[i]);
    size_t which = leaving(kind, at, n); /* multipliers that only meet outside the circle are no event */
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
    CycleMotion motion = cycle_create(cycle, 0, walk->stop);
    for (size_t i = 0; i < n; i++)
        walk->gap[i] = (here->at[i] + length * here->tangent[i]) * walk->scale;
    cycle.kind->set_state(motion.own, walk->gap);
    double *peak = cycle.kind->peaks(motion.own);
    peak[0] = peak[1] = 0;
    for (size_t i = 0; i < walk->period; i++)
        cycle_run(&motion);
    bool touches = fmax(peak[0], peak[1]) > 0, whole = cycle_status(&motion) != CYCLE_INTERRUPTED;
    cycle_destroy(&motion);
    return whole && touches != (here->peak > 0);
}

/* Sets `skew` (states) to what parts an orbit from its mirror image, in units of the scale, and returns its length.
 * Returns 0 if its image is itself, or there is none. */
static double find_skew(const Walk *walk, const Place *place, double *skew) {
    Cycle cycle = walk->family->at(walk->family->context, value_of(walk, place->at));
    if (!cycle.given || !cycle.kind->mirror || walk->period % 2 == 0)
        return 0;
    CycleMotion motion = cycle_create(cycle, 0, walk->stop);
    for (size_t i = 0; i < walk->states; i++)
        skew[i] = place->at[i] * walk->scale;
    cycle.kind->set_state(motion.own, skew);
    for (size_t i = 0; i < walk->period / 2; i++)
        cycle_run(&motion);
    cycle.kind->mirror(motion.own);
    cycle.kind->state(motion.own, skew);
    cycle_destroy(&motion);
    for (size_t i = 0; i < walk->states; i++)
        skew[i] = place->at[i] - skew[i] / walk->scale;
    double length = sqrt(dot(skew, skew, walk->states));
    return length > ORBIT_APART * sqrt(dot(place->at, place->at, walk->states)) ? length : 0;
}

/* True if an orbit becomes its mirror image between two places: what parts the two turns round. */
static bool turns_over(const Walk *walk, const Place *a, const Place *b) {
    double *skew = memory_zeroed(2 * walk->states, sizeof *skew), *other = skew + walk->states;
    bool apart = find_skew(walk, a, skew) > 0 && find_skew(walk, b, other) > 0,
         turns = apart && dot(skew, other, walk->states) < 0;
    memory_free(skew);
    return turns;
}

/* Walking -----------------------------------------------------------------------------------------------------------
 */

/* Adds the events between two places, in room for a third one. Returns FOLLOW_IMAGE if the curve ends at the last of
 * them, FOLLOW_STOPPED if interrupted, before the event that was looked for then, and FOLLOW_LONG if it goes on. */
static FollowEnd add_events(Walk *walk, FollowBranch *branch, const Place *here, const Place *next, Place *between) {
    static const FollowKind kinds[] = {FOLLOW_FOLD, FOLLOW_FLIP, FOLLOW_PITCHFORK, FOLLOW_NEIMARK, FOLLOW_TOUCH};
    size_t n = walk->states;
    bool met = false, turned = is_between(FOLLOW_FOLD, here, next, n);
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds && !met; k++) {
        bool found = !(kinds[k] == FOLLOW_PITCHFORK && turned) && is_between(kinds[k], here, next, n) &&
                     locate(walk, kinds[k], here, next, between);
        met = found && kinds[k] == FOLLOW_FOLD && turns_over(walk, here, next);
        if (stop_requested(walk->stop))
            return FOLLOW_STOPPED;
        if (found)
            add_point(branch, walk, met ? FOLLOW_PITCHFORK : kinds[k], between);
    }
    return met ? FOLLOW_IMAGE : FOLLOW_LONG;
}

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
            bool touches = touches_beyond(walk, &here, BEYOND * longest);
            end = stop_requested(walk->stop) ? FOLLOW_STOPPED : FOLLOW_LOST;
            if (touches && end == FOLLOW_LOST)
                add_point(branch, walk, FOLLOW_TOUCH, &here);
            break;
        }
        FollowEnd event = add_events(walk, branch, &here, &next, &between);
        if (event != FOLLOW_LONG) {
            end = event;
            break;
        }
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

/* Creates the memory of a walk. */
static Walk begin_walk(const FollowFamily *family, size_t states, size_t period, const double *point, double rest,
                       const Stop *stop) {
    size_t n = states, size = n + 1;
    Walk walk = {.family = family, .stop = stop, .states = n, .period = period};
    walk.scale = fmax(sqrt(dot(point, point, n)), rest);
    walk.memory = memory_zeroed(n * n + n + size * size + 4 * size, sizeof *walk.memory);
    walk.derivative = walk.memory;
    walk.gap = walk.derivative + n * n;
    walk.system = walk.gap + n;
    walk.column = walk.system + size * size;
    walk.pivots = memory_zeroed(size, sizeof *walk.pivots);
    return walk;
}

static void end_walk(Walk *walk) {
    memory_free(walk->pivots);
    memory_free(walk->memory);
}

/* Walks both ways from a place, against its tangent first. */
static void walk_both(Walk *walk, FollowBranch *branch, Place *from, double step) {
    for (int way = 0; way < 2; way++) {
        for (size_t i = 0; i <= walk->states; i++)
            from->tangent[i] = -from->tangent[i];
        if (way == 0) {
            branch->below = walk_on(walk, branch, from, step);
            reverse(branch);
            branch->start = branch->count;
            add_point(branch, walk, FOLLOW_STEP, from);
        } else {
            branch->above = walk_on(walk, branch, from, step);
        }
    }
}

/* Sets a place of the curve without its tangent. */
static void set_place(Place *place, const Walk *walk, const double *point, double value) {
    for (size_t i = 0; i < walk->states; i++)
        place->at[i] = point[i] / walk->scale;
    place->at[walk->states] = (value - walk->family->from) / (walk->family->to - walk->family->from);
}

bool follow_run(FollowBranch *branch, const FollowFamily *family, double value, const double *point, size_t period,
                double step, const Stop *stop) {
    Cycle cycle = family->at(family->context, value);
    *branch = (FollowBranch){.period = period};
    if (!cycle.given)
        return false;
    size_t n = cycle_states(cycle);
    Walk walk = begin_walk(family, n, period, point, cycle_rest_state(cycle), stop);
    double *room = place_room(n), *other = place_room(n);
    Place start = place_of(room, n), up = place_of(other, n);
    branch->states = n;
    set_place(&start, &walk, point, value);
    start.tangent[n] = 1;
    bool good = step_to(&walk, &start, 0, &up) > 0;
    if (good)
        walk_both(&walk, branch, &up, step);
    memory_free(room);
    memory_free(other);
    end_walk(&walk);
    return good;
}

/* Sets `along` (states) to the unit eigenvector of a derivative (states x states), which is lost, to the multiplier
 * nearest to `sign`. */
static bool leaving_direction(double *derivative, size_t states, double sign, double *along) {
    lapack_int n = (lapack_int)states;
    double *re = memory_zeroed(states * (states + 2), sizeof *re), *im = re + states, *vectors = im + states;
    bool good = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'V', n, derivative, n, re, im, NULL, 1, vectors, n) == 0;
    size_t nearest = 0;
    for (size_t i = 1; i < states && good; i++)
        if (real_hypot(re[i] - sign, im[i]) < real_hypot(re[nearest] - sign, im[nearest]))
            nearest = i;
    memcpy(along, vectors + nearest * states, states * sizeof *along);
    good = good && im[nearest] == 0;
    memory_free(re);
    return good;
}

/* Returns the direction of the parameter in which a branch does not go from a pitchfork at its end; 0: it is not at its
 * end. */
static double beyond_end(const FollowBranch *branch, size_t at) {
    bool first = at == 0, last = at + 1 == branch->count;
    if (branch->points[at].kind != FOLLOW_PITCHFORK || branch->count < 2 || (!first && !last))
        return 0;
    return branch->points[at].value > branch->points[first ? 1 : at - 1].value ? 1 : -1;
}

bool follow_branch_off(FollowBranch *begun, const FollowFamily *family, const FollowBranch *branch, size_t at,
                       double step, const Stop *stop) {
    const double *point = follow_state(branch, at);
    double value = branch->points[at].value;
    Cycle cycle = family->at(family->context, value);
    bool flips = branch->points[at].kind == FOLLOW_FLIP;
    size_t period = flips ? 2 * branch->period : branch->period;
    *begun = (FollowBranch){.period = period};
    if (!cycle.given)
        return false;
    size_t n = branch->states;
    Walk walk = begin_walk(family, n, period, point, cycle_rest_state(cycle), stop);
    double *room = place_room(n), *other = place_room(n);
    Place start = place_of(room, n), next = place_of(other, n);
    begun->states = n;
    set_place(&start, &walk, point, value);
    memcpy(walk.gap, point, n * sizeof *point);
    double length = step / 4, beyond = beyond_end(branch, at);
    bool good = beyond != 0 || (orbit_map(cycle, walk.gap, branch->period, walk.derivative, stop) == ORBIT_GOOD &&
                                leaving_direction(walk.derivative, n, flips ? -1 : 1, start.tangent));
    start.tangent[n] = beyond;
    while (good && length >= SMALLEST * step && !step_to(&walk, &start, length, &next))
        length /= 2;
    good = good && length >= SMALLEST * step && !stop_requested(stop);
    if (good && beyond != 0) {
        for (size_t i = 0; i <= n; i++)
            next.tangent[i] *= beyond;
        walk_both(&walk, begun, &next, step);
    } else if (good) {
        begun->below = FOLLOW_LOST; /* where it begins */
        add_point(begun, &walk, FOLLOW_STEP, &next);
        begun->above = walk_on(&walk, begun, &next, step);
    }
    memory_free(room);
    memory_free(other);
    end_walk(&walk);
    return good;
}

void follow_clear(FollowBranch *branch) {
    memory_free(branch->points);
    memory_free(branch->memory);
    *branch = (FollowBranch){0};
}
