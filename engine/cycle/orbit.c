#include "cycle/orbit.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/stop.h"
#include "base/real.h"

/* Fraction of the state's length: a start that misses closing by more does not lead to a nearby orbit. */
static const double FAR = 1;
enum { ITERATIONS_MOST = 12 };

static double length_of(const double *vector, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += vector[i] * vector[i];
    return sqrt(sum);
}

/* Returns the distance as a fraction of the size, or of `rest` if larger; 0 for equal states. */
static double share(double apart, double size, double rest) {
    return apart > 0 ? apart / fmax(size, rest) : 0;
}

OrbitAnswer orbit_map(Cycle cycle, double *state, size_t cycles, double *derivative, const Stop *stop) {
    const CycleKind *kind = cycle.kind;
    size_t done = 0;
    CycleMotion motion = cycle_create(cycle, derivative ? cycle_states(cycle) : 0, stop);
    kind->set_state(motion.own, state);
    kind->unit_tangents(motion.own);
    for (; done < cycles && cycle_status(&motion) == CYCLE_GOOD && !stop_requested(stop); done++)
        cycle_run(&motion);
    CycleStatus status = cycle_status(&motion);
    OrbitAnswer answer = ORBIT_GOOD;
    if (status == CYCLE_INTERRUPTED || (status == CYCLE_GOOD && done < cycles))
        answer = ORBIT_INTERRUPTED;
    else if (status != CYCLE_GOOD)
        answer = ORBIT_NONE;
    kind->state(motion.own, state);
    for (size_t t = 0; t < motion.tangents; t++)
        kind->tangent(motion.own, t, derivative + t * motion.states);
    cycle_destroy(&motion);
    return answer;
}

/* Computes x -= (derivative - 1)^-1 gap; destroys the derivative and the gap. */
static bool newton_step(double *state, double *derivative, double *gap, size_t states) {
    lapack_int n = (lapack_int)states;
    lapack_int *pivots = memory_zeroed(states, sizeof *pivots);
    for (size_t i = 0; i < states; i++)
        derivative[i * states + i] -= 1;
    bool good = LAPACKE_dgesv(LAPACK_COL_MAJOR, n, 1, derivative, n, pivots, gap, n) == 0;
    for (size_t i = 0; good && i < states; i++)
        state[i] -= gap[i];
    memory_free(pivots);
    return good;
}

static double magnitude(const Orbit *orbit, size_t which) {
    return real_hypot(orbit->multiplier_re[which], orbit->multiplier_im[which]);
}

/* Puts the multipliers in order of decreasing magnitude; those of a pair stay side by side. */
static void sort_multipliers(Orbit *orbit) {
    for (size_t i = 1; i < orbit->states; i++)
        for (size_t k = i; k > 0 && magnitude(orbit, k) > magnitude(orbit, k - 1); k--) {
            double re = orbit->multiplier_re[k], im = orbit->multiplier_im[k];
            orbit->multiplier_re[k] = orbit->multiplier_re[k - 1];
            orbit->multiplier_im[k] = orbit->multiplier_im[k - 1];
            orbit->multiplier_re[k - 1] = re;
            orbit->multiplier_im[k - 1] = im;
        }
}

/* Classifies the crossing of the unit circle nearest to the largest multiplier. */
static void name_leaving(Orbit *orbit) {
    sort_multipliers(orbit);
    orbit->largest = magnitude(orbit, 0);
    orbit->leaving = orbit->multiplier_im[0] != 0  ? ORBIT_NEIMARK
                     : orbit->multiplier_re[0] < 0 ? ORBIT_FLIP
                                                   : ORBIT_FOLD;
}

static bool find_multipliers(Orbit *orbit, double *derivative) {
    lapack_int n = (lapack_int)orbit->states;
    bool good = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', n, derivative, n, orbit->multiplier_re, orbit->multiplier_im,
                              NULL, 1, NULL, 1) == 0;
    name_leaving(orbit);
    return good;
}

OrbitAnswer orbit_find(Orbit *orbit, Cycle cycle, const double *start, size_t period, const Stop *stop) {
    size_t states = cycle_states(cycle);
    *orbit = (Orbit){.period = period, .states = states, .point = memory_zeroed(3 * states, sizeof(double))};
    orbit->multiplier_re = orbit->point + states;
    orbit->multiplier_im = orbit->multiplier_re + states;
    memcpy(orbit->point, start, states * sizeof *start);
    double *derivative = memory_zeroed(states * states, sizeof *derivative);
    double *gap = memory_zeroed(states, sizeof *gap);
    double rest = cycle_rest_state(cycle);
    bool found = false;
    OrbitAnswer answer = ORBIT_GOOD;
    for (int i = 0; i < ITERATIONS_MOST && answer == ORBIT_GOOD && !found; i++) {
        memcpy(gap, orbit->point, states * sizeof *gap);
        answer = orbit_map(cycle, gap, period, derivative, stop);
        for (size_t k = 0; k < states; k++)
            gap[k] -= orbit->point[k];
        orbit->error = share(length_of(gap, states), length_of(orbit->point, states), rest);
        found = answer == ORBIT_GOOD && orbit->error < cycle.kind->closing;
        if (answer == ORBIT_GOOD && !found &&
            !(orbit->error < FAR && newton_step(orbit->point, derivative, gap, states)))
            answer = ORBIT_NONE;
    }
    found = found && find_multipliers(orbit, derivative);
    memory_free(derivative);
    memory_free(gap);
    if (!found)
        orbit_clear(orbit);
    return found ? ORBIT_GOOD : answer == ORBIT_INTERRUPTED ? ORBIT_INTERRUPTED : ORBIT_NONE;
}

bool orbit_is_stable(const Orbit *orbit) {
    return orbit->largest < 1;
}

double orbit_distance(const Orbit *orbit, Cycle cycle, const double *state, const Stop *stop) {
    double rest = cycle_rest_state(cycle), nearest = HUGE_VAL, *point = memory_zeroed(2 * orbit->states, sizeof *point),
           *apart = point + orbit->states;
    memcpy(point, orbit->point, orbit->states * sizeof *point);
    for (size_t i = 0; i < orbit->period; i++) {
        for (size_t k = 0; k < orbit->states; k++)
            apart[k] = state[k] - point[k];
        nearest = fmin(nearest, share(length_of(apart, orbit->states), length_of(point, orbit->states), rest));
        orbit_map(cycle, point, 1, NULL, stop);
    }
    memory_free(point);
    return nearest;
}

/* Replaces an orbit found with a multiple of its period by the orbit with its own period. Returns false if
 * interrupted. */
static bool reduce_period(Orbit *orbit, Cycle cycle, const Stop *stop) {
    for (size_t period = 1; period < orbit->period; period++) {
        Orbit shorter;
        OrbitAnswer answer =
            orbit->period % period ? ORBIT_NONE : orbit_find(&shorter, cycle, orbit->point, period, stop);
        if (answer == ORBIT_INTERRUPTED)
            return false;
        if (answer == ORBIT_NONE)
            continue;
        if (orbit_distance(&shorter, cycle, orbit->point, stop) < ORBIT_SETTLED) {
            orbit_clear(orbit);
            *orbit = shorter;
            return true;
        }
        orbit_clear(&shorter);
    }
    return true;
}

OrbitAnswer orbit_settle(Orbit *orbit, Cycle cycle, const double *state, size_t period, double near, const Stop *stop) {
    OrbitAnswer answer = orbit_find(orbit, cycle, state, period, stop);
    if (answer != ORBIT_GOOD)
        return answer;
    bool near_it = orbit_is_stable(orbit) && orbit_distance(orbit, cycle, state, stop) < near;
    if (near_it && reduce_period(orbit, cycle, stop) && !stop_requested(stop))
        return ORBIT_GOOD;
    orbit_clear(orbit);
    return stop_requested(stop) ? ORBIT_INTERRUPTED : ORBIT_NONE;
}

OrbitImage orbit_image(const Orbit *orbit, Cycle cycle, const Stop *stop) {
    if (!cycle.kind->mirror)
        return ORBIT_IMAGE_NONE;
    CycleMotion motion = cycle_create(cycle, 0, stop);
    double *state = memory_zeroed(orbit->states, sizeof *state);
    cycle.kind->set_state(motion.own, orbit->point);
    cycle.kind->mirror(motion.own);
    cycle.kind->state(motion.own, state);
    bool own = orbit_distance(orbit, cycle, state, stop) < ORBIT_APART;
    memory_free(state);
    cycle_destroy(&motion);
    return own ? ORBIT_IMAGE_OWN : ORBIT_IMAGE_OTHER;
}

double orbit_peak(const Orbit *orbit, Cycle cycle, const Stop *stop) {
    CycleMotion motion = cycle_create(cycle, 0, stop);
    cycle.kind->set_state(motion.own, orbit->point);
    double *peak = cycle.kind->peaks(motion.own);
    peak[0] = peak[1] = 0;
    for (size_t i = 0; i < orbit->period; i++)
        cycle_run(&motion);
    double largest = fmax(peak[0], peak[1]);
    cycle_destroy(&motion);
    return largest;
}

void orbit_clear(Orbit *orbit) {
    memory_free(orbit->point);
    *orbit = (Orbit){0};
}
