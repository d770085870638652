#include "cycle/section.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

#include "base/memory.h"
#include "base/real.h"

/* Relative distance: a motion whose every return is closer repeats. A transient that shrinks by 1 % per cycle is
 * then within 1 % of its orbit. */
static const double RETURN_NEAR = 1e-4;

/* Relative distance: a motion whose returns are this close and approach is still settling. A chaotic motion
 * sometimes returns this close, but not for a quarter of the record. */
static const double RETURN_SETTLING = 0.05;

static void reserve(Section *section, size_t count) {
    size_t states = section->states;
    section->state = memory_reserve(section->state, &section->state_capacity, count * states, sizeof(double));
    section->deflection = memory_reserve(section->deflection, &section->deflection_capacity, count, sizeof(double));
    section->velocity = memory_reserve(section->velocity, &section->velocity_capacity, count, sizeof(double));
    section->peak = memory_reserve(section->peak, &section->peak_capacity, 2 * count, sizeof(double));
}

void section_add(Section *section, CycleMotion *motion) {
    size_t states = section->states = motion->states, at = section->count++;
    reserve(section, section->count);
    motion->cycle.kind->state(motion->own, section->state + at * states);
    double tip[2], *peak = motion->cycle.kind->peaks(motion->own);
    motion->cycle.kind->tip(motion->own, tip);
    section->deflection[at] = tip[0];
    section->velocity[at] = tip[1];
    for (size_t side = 0; side < CYCLE_SIDES; side++) {
        section->peak[2 * at + side] = peak[side];
        peak[side] = 0;
    }
}

void section_join(Section *section, const Section *from, size_t count) {
    size_t at = section->count, states = section->states = from->states;
    section->count += count;
    reserve(section, section->count);
    for (size_t i = 0; i < count * states; i++)
        section->state[at * states + i] = from->state[i];
    for (size_t i = 0; i < count; i++) {
        section->deflection[at + i] = from->deflection[i];
        section->velocity[at + i] = from->velocity[i];
    }
    for (size_t i = 0; i < CYCLE_SIDES * count; i++)
        section->peak[CYCLE_SIDES * at + i] = from->peak[i];
}

void section_clear(Section *section) {
    memory_free(section->state);
    memory_free(section->deflection);
    memory_free(section->velocity);
    memory_free(section->peak);
    *section = (Section){0};
}

SectionPeaks section_peaks(const Section *section) {
    SectionPeaks peaks = {.min = HUGE_VAL};
    double sum = 0;
    for (size_t i = 0; i < 2 * section->count; i++) {
        double peak = section->peak[i];
        if (peak <= 0)
            continue;
        peaks.min = fmin(peaks.min, peak);
        peaks.max = fmax(peaks.max, peak);
        sum += peak;
        peaks.count++;
    }
    peaks.mean = peaks.count ? sum / (double)peaks.count : 0;
    peaks.min = peaks.count ? peaks.min : 0;
    return peaks;
}

double section_return(const Section *section, size_t lag, double rest) {
    assert(lag < section->count);
    const double *last = section_last(section), *before = last - lag * section->states;
    double apart = 0, size = 0;
    for (size_t i = 0; i < section->states; i++) {
        apart += (last[i] - before[i]) * (last[i] - before[i]);
        size += last[i] * last[i];
    }
    return apart > 0 ? sqrt(apart) / fmax(sqrt(size), rest) : 0;
}

/* Deflection and velocity of the tip in one unit, m/s. */
typedef struct Tip {
    const double *deflection, *velocity;
    double omega, rest;
} Tip;

static double return_of(const Tip *tip, size_t at, size_t lag) {
    double along = tip->omega * (tip->deflection[at] - tip->deflection[at - lag]);
    double apart = real_hypot(along, tip->velocity[at] - tip->velocity[at - lag]);
    return apart > 0 ? apart / fmax(real_hypot(tip->omega * tip->deflection[at], tip->velocity[at]), tip->rest) : 0;
}

/* Returns the largest distance between cycles that are `lag` apart, from `from` up to but excluding `to`. */
static double largest_return(const Tip *tip, size_t lag, size_t from, size_t to) {
    double largest = 0;
    for (size_t i = from; i < to; i++)
        largest = fmax(largest, return_of(tip, i, lag));
    return largest;
}

/* True if the returns get closer from quarter to quarter of the record. */
static bool returns_settle(const Tip *tip, size_t count, size_t lag) {
    enum { QUARTERS = 4 };
    double before = HUGE_VAL;
    for (size_t quarter = 0; quarter < QUARTERS; quarter++) {
        size_t seen = count - lag;
        double largest =
            largest_return(tip, lag, lag + seen * quarter / QUARTERS, lag + seen * (quarter + 1) / QUARTERS);
        if (largest >= before)
            return false;
        before = largest;
    }
    return before < RETURN_SETTLING;
}

int section_period(const double *deflection, const double *velocity, size_t count, double omega, double rest) {
    Tip tip = {deflection, velocity, omega, omega * rest};
    bool decided = true;
    for (size_t lag = 1; lag <= SECTION_PERIOD_MOST; lag++) {
        size_t span = count / 2 > 2 * lag ? count / 2 : 2 * lag;
        if (count < span + lag)
            decided = false;
        else if (largest_return(&tip, lag, count - span, count) < RETURN_NEAR)
            return decided ? (int)lag : SECTION_UNDECIDED; /* a shorter period to which it settles is excluded */
        else if (returns_settle(&tip, count, lag))
            decided = false;
    }
    return decided ? SECTION_NONE : SECTION_UNDECIDED;
}
