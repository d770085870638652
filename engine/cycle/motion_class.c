#include "cycle/motion_class.h"

#include <math.h>

const char *const motion_class_names[MOTION_CLASSES] = {
    [MOTION_CLASS_FREE] = "without contact",
    [MOTION_CLASS_PERIODIC] = "periodic",
    [MOTION_CLASS_QUASI_PERIODIC] = "quasi-periodic",
    [MOTION_CLASS_CHAOTIC] = "chaotic",
    [MOTION_CLASS_TRANSIENT] = "transient",
    [MOTION_CLASS_UNDETERMINED] = "undetermined",
    [MOTION_CLASS_CHATTERS] = "chatters",
    [MOTION_CLASS_DIVERGED] = "diverged",
    [MOTION_CLASS_NOT_PERIODIC] = "not periodic",
};

MotionClass motion_class_of(const Response *response) {
    switch (response->verdict) {
    case RESPONSE_PERIODIC:
        return response->peaks.count ? MOTION_CLASS_PERIODIC : MOTION_CLASS_FREE;
    case RESPONSE_QUASI_PERIODIC:
        return MOTION_CLASS_QUASI_PERIODIC;
    case RESPONSE_CHAOTIC:
        return MOTION_CLASS_CHAOTIC;
    case RESPONSE_TRANSIENT:
        return MOTION_CLASS_TRANSIENT;
    case RESPONSE_CHATTERS:
        return MOTION_CLASS_CHATTERS;
    case RESPONSE_DIVERGED:
        return MOTION_CLASS_DIVERGED;
    case RESPONSE_UNDETERMINED:
    case RESPONSE_STIFF:
    case RESPONSE_INTERRUPTED:
        break;
    }
    return MOTION_CLASS_UNDETERMINED;
}

MotionClass motion_class_of_record(CycleStatus status, int period, bool touches) {
    if (status == CYCLE_CHATTERS || status == CYCLE_DIVERGED)
        return status == CYCLE_CHATTERS ? MOTION_CLASS_CHATTERS : MOTION_CLASS_DIVERGED;
    if (status != CYCLE_GOOD || period == SECTION_UNDECIDED)
        return MOTION_CLASS_UNDETERMINED;
    if (period == SECTION_NONE)
        return MOTION_CLASS_NOT_PERIODIC;
    return touches ? MOTION_CLASS_PERIODIC : MOTION_CLASS_FREE;
}

double motion_class_life(const Response *response) {
    const HalfLife *half = &response->survival.half_life;
    if (!response->survival.lanes)
        return (double)response->wandering.count;
    return isfinite(half->value) ? half->value : fmax(half->low, (double)response->wandering.count);
}

static bool is_even(const Response *response) {
    return response->verdict == RESPONSE_QUASI_PERIODIC &&
           response->peaks.max - response->peaks.min <= MOTION_CLASS_EVEN * response->peaks.max;
}

bool motion_class_is_regular(const Response *response) {
    return response->verdict == RESPONSE_PERIODIC || is_even(response) ||
           (response->verdict == RESPONSE_TRANSIENT && motion_class_life(response) <= MOTION_CLASS_LASTS);
}

size_t motion_class_attractor(const Response *response, double *peak) {
    const Survival *survival = &response->survival;
    const SurvivalAttractor *most = survival->attractor_count ? &survival->attractors[0] : NULL;
    for (size_t i = 1; i < survival->attractor_count; i++)
        most = survival->attractors[i].lanes > most->lanes ? &survival->attractors[i] : most;
    *peak = most ? most->peak : response->orbit.period ? response->orbit_peak : (double)NAN;
    return most ? most->period : response->orbit.period;
}
