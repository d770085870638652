#include "cycle/shape.h"

#include <math.h>

#include "base/memory.h"
#include "base/real.h"

/* Rotation ----------------------------------------------------------------------------------------------------------
 */

static const double AGREE = 1e-3; /* of a turn: halves that differ by more turn about no middle */

/* The turns from each point to the next, as shares between 0 and 1, weighted. */
static double mean_turn(const double *along, const double *across, size_t count, double x, double y) {
    double sum = 0, weight = 0;
    for (size_t i = 0; i + 1 < count; i++) {
        double t = (double)(i + 1) / (double)count, w = real_exp(-1 / (t * (1 - t)));
        double turn = real_atan2(across[i + 1] - y, along[i + 1] - x) - real_atan2(across[i] - y, along[i] - x);
        turn /= 2 * M_PI;
        sum += w * (turn - floor(turn));
        weight += w;
    }
    return sum / weight;
}

static double fold(double turn) {
    return turn > 0.5 ? 1 - turn : turn;
}

ShapeRotation shape_rotation(const Section *section, size_t bands, double omega) {
    size_t count = section->count / bands, half = count / 2;
    double x = 0, y = 0, *along = memory_zeroed(2 * count, sizeof *along), *across = along + count;
    for (size_t i = 0; i < count; i++) {
        along[i] = omega * section->deflection[i * bands];
        across[i] = section->velocity[i * bands];
        x += along[i] / (double)count;
        y += across[i] / (double)count;
    }
    double whole = mean_turn(along, across, count, x, y), first = mean_turn(along, across, half, x, y),
           second = mean_turn(along + half, across + half, count - half, x, y);
    memory_free(along);
    double error = fabs(first - second);
    return error < AGREE ? (ShapeRotation){fold(whole), error} : (ShapeRotation){NAN, NAN};
}

/* Bands -------------------------------------------------------------------------------------------------------------
 */

typedef struct Nearest {
    double same[SHAPE_BANDS_MOST + 1], other[SHAPE_BANDS_MOST + 1]; /* squares of distances, by number of bands */
} Nearest;

/* Finds the nearest states of one among all, of its own and of another class, for each number of classes. */
static Nearest find_nearest(const Section *section, size_t first, size_t at) {
    Nearest nearest;
    for (size_t p = 0; p <= SHAPE_BANDS_MOST; p++)
        nearest.same[p] = nearest.other[p] = HUGE_VAL;
    const double *own = section->state + at * section->states;
    for (size_t i = first; i < section->count; i++) {
        const double *state = section->state + i * section->states;
        double square = 0;
        for (size_t k = 0; k < section->states; k++)
            square += (state[k] - own[k]) * (state[k] - own[k]);
        size_t lag = i > at ? i - at : at - i;
        for (size_t p = 2; i != at && p <= SHAPE_BANDS_MOST; p++) {
            double *which = lag % p ? nearest.other : nearest.same;
            which[p] = real_min(which[p], square);
        }
    }
    return nearest;
}

size_t shape_bands(const Section *section) {
    size_t first = section->count > SHAPE_BANDS_CYCLES ? section->count - SHAPE_BANDS_CYCLES : 0, bands = 1;
    double hole[SHAPE_BANDS_MOST + 1] = {0}, gap[SHAPE_BANDS_MOST + 1];
    for (size_t p = 0; p <= SHAPE_BANDS_MOST; p++)
        gap[p] = HUGE_VAL;
    for (size_t i = first; i < section->count; i++) {
        Nearest nearest = find_nearest(section, first, i);
        for (size_t p = 2; p <= SHAPE_BANDS_MOST; p++) {
            hole[p] = real_max(hole[p], nearest.same[p]);
            gap[p] = real_min(gap[p], nearest.other[p]);
        }
    }
    for (size_t p = 2; p <= SHAPE_BANDS_MOST; p++)
        if (isfinite(gap[p]) && gap[p] > hole[p])
            bands = p;
    return bands;
}
